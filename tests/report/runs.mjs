// Runs of the program whose reports are tested, in a folder that is removed at the end.
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { root } from './browser.mjs';

const program = process.env.FOURPOST ?? join(root, 'build', 'release', 'fourpost');
export const scratch = mkdtempSync(join(tmpdir(), 'fourpost report '));
process.on('exit', () => rmSync(scratch, { recursive: true, force: true }));

export function fourpost(...args) {
  return execFileSync(program, args, { encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'] });
}

/** A fit whose verdict is poor, with status 1, as its model is: the run's folder holds all the same. */
export function poorlyFitted(study, folder) {
  const { status } = spawnSync(program, ['fit', study, '-o', folder, '--no-suggest'], { stdio: 'ignore' });
  assert.equal(status, 1);
}

/** Fits a study of studies/ and gives the run's folder. */
export function fitted(study) {
  const folder = join(scratch, study.replaceAll('/', '_'));
  fourpost('fit', join(root, 'studies', study), '-o', folder, '--threads', '2');
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
