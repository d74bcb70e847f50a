// SPDX-License-Identifier: MIT
// The script that emscripten writes beside shigusa.wasm, as far as door.ts uses it. Pointers are numbers;
// memory that grows replaces the views, so they are read anew after each call.

export interface ShigusaModule {
  readonly HEAPU8: Uint8Array;
  readonly HEAPU32: Uint32Array;
  readonly HEAPF64: Float64Array;
  UTF8ToString(pointer: number): string;
  stringToUTF8(text: string, pointer: number, size: number): void;
  lengthBytesUTF8(text: string): number;
  /** Asked by the watch of shigusa_script_watch; true stops the search. */
  report: (fraction: number, evaluations: number, bestScore: number) => boolean;

  _malloc(size: number): number;
  _free(pointer: number): void;
  _shigusa_script_watch(): number;
  _shigusa_script_set_starts(text: number, size: number): number;

  _shigusa_abi_version(): number;
  _shigusa_version(): number;
  _shigusa_check_version(abi: number, version: number): number;
  _shigusa_message(): number;
  _shigusa_failure(json: number): number;
  _shigusa_bytes_data(bytes: number): number;
  _shigusa_bytes_size(bytes: number): number;
  _shigusa_bytes_free(bytes: number): void;
  _shigusa_facts(json: number): number;

  _shigusa_character_create(spec: number, file: number, fileSize: number, character: number): number;
  _shigusa_character_free(character: number): void;
  _shigusa_character_describe(character: number, json: number): number;

  _shigusa_generate(character: number, task: number, threads: number, watch: number, result: number): number;
  _shigusa_character_of_nodes(spec: number, nodes: number, character: number): number;
  _shigusa_result_of_angles(
    character: number, task: number, angles: number, frames: number, columns: number, fps: number, result: number): number;
  _shigusa_restore_watched(character: number, summary: number, watch: number, result: number): number;
  _shigusa_replay(result: number, candidate: number, assignments: number, edited: number): number;
  _shigusa_replay_work(result: number, candidate: number, edit: number, watch: number, edited: number): number;
  _shigusa_mirror(result: number, mirrored: number): number;
  _shigusa_result_free(result: number): void;
  _shigusa_result_candidates(result: number): number;
  _shigusa_result_describe(result: number, json: number): number;
  _shigusa_result_parameters(result: number, candidate: number, json: number): number;
  _shigusa_result_action_parameters(result: number, candidate: number, action: number, json: number): number;
  _shigusa_result_export_with(
    result: number, candidate: number, format: number, options: number, file: number,
  ): number;
  _shigusa_result_series(
    result: number, candidate: number, series: number, values: number, frames: number, columns: number,
  ): number;
  _shigusa_result_series_at(
    result: number, candidate: number, series: number, fps: number, table: number, frames: number, columns: number,
  ): number;
  _shigusa_result_table(
    result: number, candidate: number, series: number, options: number, table: number, about: number,
  ): number;
  _shigusa_score_clip(name: number, file: number, fileSize: number, options: number, json: number): number;
}

export interface ModuleSettings {
  instantiateWasm?: (imports: WebAssembly.Imports, received: (instance: WebAssembly.Instance) => void) => object;
  onAbort?: (reason: unknown) => void;
  print?: (line: string) => void;
  printErr?: (line: string) => void;
}

export default function createModule(settings?: ModuleSettings): Promise<ShigusaModule>;
