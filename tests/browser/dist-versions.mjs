// Builds of dist/ in temporary folders, for tests that upload another version.

import { cp, mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { buildDist } from '../../scripts/build-dist.mjs';

const www = join(dirname(fileURLToPath(import.meta.url)), '..', '..', 'www');

/** An empty folder that goes with the process. */
export async function temporaryFolder() {
  const folder = await mkdtemp(join(tmpdir(), 'pathlight-'));
  process.once('exit', () => rmSync(folder, { recursive: true, force: true }));
  return folder;
}

/** A build of the page as it is, not compressed. */
export async function plainDist() {
  const folder = await temporaryFolder();
  return { folder, files: await buildDist({ out: folder, compress: false }) };
}

/** A build of another version: main.js has one more line. */
export async function changedDist() {
  const [page, folder] = [await temporaryFolder(), await temporaryFolder()];
  await cp(www, page, { recursive: true });
  await writeFile(join(page, 'main.js'), `${await readFile(join(page, 'main.js'), 'utf8')}// changed\n`);
  const files = await buildDist({ page, out: folder, compress: false });
  await rm(page, { recursive: true });
  return { folder, files };
}
