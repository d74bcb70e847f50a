// SPDX-License-Identifier: MIT
// A reporter of node:test that names the files whose tests failed, for scripts/test_studio.
export default async function* failedFiles(source) {
  for await (const { type, data } of source) {
    if (type === 'test:fail' && data.file) yield `${data.file}\n`;
  }
}
