// The committed bundle is what the sources make, and keeps the licences.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { root } from './browser.mjs';

test('the bundle is what the sources make', () => {
  execFileSync(process.execPath, [join(root, 'analysis', 'report', 'web', 'build.mjs'), '--check'], { stdio: 'pipe' });
});

test('the bundle keeps the licences of its libraries', () => {
  const script = readFileSync(join(root, 'analysis', 'report', 'bundle', 'report.js'), 'utf8');
  assert.match(script, /three\.js authors/);
  assert.match(script, /Leon Sorokin/);
  assert.match(script, /The above copyright notice and this permission notice shall be included/);
});
