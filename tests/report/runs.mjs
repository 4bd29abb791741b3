// Runs of the program whose reports are tested, in a folder that is removed at the end.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { cpSync, existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { root } from './browser.mjs';

const program = process.env.FOURPOST ?? join(root, 'build', 'release', 'fourpost');
export const scratch = mkdtempSync(join(tmpdir(), 'fourpost report '));
process.on('exit', () => rmSync(scratch, { recursive: true, force: true }));

export function fourpost(...args) {
  return execFileSync(program, args, { encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'] });
}

/** Studies of studies/ whose fits are shown; what a fit suggests is shown of the car alone. */
export const studies = [
  'landrover110/model1.yaml', 'landrover110/model2.yaml', 'single_wheel_station/model2.yaml', 'damper/model1.yaml', 'damper/model2.yaml',
];

/** The folder of such a fit: made once for all files where FOURPOST_RUNS names a place, else once for this one. */
export function fitted(study) {
  assert.ok(studies.includes(study), study);
  const folder = join(process.env.FOURPOST_RUNS ?? scratch, study.replaceAll('/', '_'));
  if (!existsSync(folder))
    fourpost('fit', join(root, 'studies', study), '-o', folder, '--threads', '2', ...(study.startsWith('landrover110') ? [] : ['--no-suggest']));
  return folder;
}

/** A page that compares runs: its file. */
export function compared(name, ...folders) {
  const file = join(scratch, `${name}.html`);
  fourpost('report', ...folders, '-o', file);
  return file;
}

/** A page that compares methods of search on a study: its file. */
export function methods(study, names, runs) {
  const file = join(scratch, 'methods.html');
  fourpost('compare', join(root, 'studies', study), '--methods', names, '--runs', String(runs), '-o', file);
  return file;
}

/** A copy of a run with files changed, and its report written anew: the report's file. */
export function changed(folder, name, change) {
  const copy = join(scratch, name);
  // The archive is large and no part of a report.
  cpSync(folder, copy, { recursive: true, filter: (file) => !file.endsWith('.sqlite') });
  change({
    read: (file) => readFileSync(join(copy, file), 'utf8'),
    write: (file, text) => writeFileSync(join(copy, file), text),
    remove: (file) => rmSync(join(copy, file)),
  });
  fourpost('report', copy);
  return join(copy, 'report.html');
}
