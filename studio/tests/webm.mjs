// SPDX-License-Identifier: MIT
// Reads a WebM file: its length and size, and of each picture its time, whether it stands for itself, and whether it has an opacity.

const kMasters = new Set([0x18538067, 0x1549a966, 0x1654ae6b, 0xae, 0xe0, 0x1f43b675, 0xa0, 0x75a1, 0xa6, 0x1c53bb6b, 0xbb, 0xb7]);

function vint(bytes, at, keepMarker) {
  const length = Math.clz32(bytes[at]) - 23;
  let value = keepMarker ? bytes[at] : bytes[at] & (0xff >> length);
  for (let k = 1; k < length; ++k) value = value * 256 + bytes[at + k];
  return { value, length, isUnknown: !keepMarker && value === 2 ** (7 * length) - 1 };
}

/** All elements, in their order: id, where they and their content begin, and the content of those that hold no others. */
function elements(bytes, from = 0, to = bytes.length, list = []) {
  for (let at = from; at < to;) {
    const id = vint(bytes, at, true);
    const size = vint(bytes, at + id.length, false);
    const begin = at + id.length + size.length;
    const end = size.isUnknown ? to : begin + size.value;
    list.push({ id: id.value, at, begin, data: bytes.subarray(begin, end) });
    if (kMasters.has(id.value)) elements(bytes, begin, end, list);
    at = end;
  }
  return list;
}

const number = (data) => data.reduce((value, byte) => value * 256 + byte, 0);

export function readWebm(bytes) {
  const all = elements(bytes);
  const of = (id) => all.filter((element) => element.id === id);
  const one = (id) => number(of(id)[0].data);
  const tick_s = one(0x2ad7b1) / 1e9;
  const pictures = [];
  let cluster = 0;
  for (const { id, data } of all) {
    if (id === 0xe7) cluster = number(data);
    if (id === 0xa3 || id === 0xa1) {
      const view = new DataView(data.buffer, data.byteOffset);
      pictures.push({ time_s: (cluster + view.getInt16(1)) * tick_s, isKey: id === 0xa3 ? (data[3] & 0x80) !== 0 : true, hasAlpha: false });
    }
    if (id === 0xa5) pictures.at(-1).hasAlpha = true;
    if (id === 0xfb) pictures.at(-1).isKey = false;
  }
  const segment = of(0x18538067)[0].begin;
  const duration = of(0x4489)[0].data;
  return {
    seconds: new DataView(duration.buffer, duration.byteOffset).getFloat64(0) * tick_s, width: one(0xb0), height: one(0xba), pictures,
    clusters: of(0x1f43b675).map(({ at }) => at - segment), cues: of(0xf1).map(({ data }) => number(data)),
  };
}
