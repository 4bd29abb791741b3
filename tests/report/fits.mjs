// Makes the fits that several files of tests show, anew.
import { mkdirSync, rmSync } from 'node:fs';
import { fitted, studies } from './runs.mjs';

rmSync(process.env.FOURPOST_RUNS, { recursive: true, force: true });
mkdirSync(process.env.FOURPOST_RUNS, { recursive: true });
studies.forEach(fitted);
