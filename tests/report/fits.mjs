// Makes the fits that several files of tests show, anew.
import assert from 'node:assert/strict';
import { mkdirSync, rmSync } from 'node:fs';
import { fitted, studies } from './runs.mjs';

assert.match(process.env.FOURPOST_RUNS ?? '', /browser_fits$/, 'a folder of the build, which is made anew');
rmSync(process.env.FOURPOST_RUNS, { recursive: true, force: true });
mkdirSync(process.env.FOURPOST_RUNS, { recursive: true });
studies.forEach(fitted);
