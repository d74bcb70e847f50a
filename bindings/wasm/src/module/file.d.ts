// SPDX-License-Identifier: MIT
/** The address of shigusa.wasm or starts.tsv, where a bundler takes such files as assets. */
declare const address: string;
export default address;
