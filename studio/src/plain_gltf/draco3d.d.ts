// SPDX-License-Identifier: MIT
// The part of the decoder of Draco that is used.
declare module 'draco3d/draco_decoder_nodejs.js' {
  interface Geometry {
    num_points(): number;
    num_faces(): number;
  }
  interface Attribute {
    num_components(): number;
  }
  interface Decoder {
    DecodeArrayToMesh(bytes: Uint8Array, size: number, mesh: Geometry): { ok(): boolean; error_msg(): string };
    GetAttributeByUniqueId(mesh: Geometry, id: number): Attribute;
    GetAttributeDataArrayForAllPoints(mesh: Geometry, attribute: Attribute, type: number, size: number, at: number): boolean;
    GetTrianglesUInt32Array(mesh: Geometry, size: number, at: number): boolean;
  }
  export interface DracoModule {
    Decoder: new () => Decoder;
    Mesh: new () => Geometry;
    HEAPU8: Uint8Array;
    _malloc(size: number): number;
    [type: `DT_${string}`]: number;
  }
  export default function create(settings: { wasmBinary: ArrayBuffer }): Promise<DracoModule>;
}
