// SPDX-License-Identifier: MIT
// A film whose pictures are drawn and encoded one by one, each with its own time. Where the film is transparent, each picture has a second one,
// whose brightness is the opacity.
import { bitsPerSecond, canvasOf, type Film, type FilmSettings } from './film_settings';
import { type Picture, webmFile } from './webm_file';

const kCodecs = [['vp09.00.41.08', 'V_VP9'], ['vp8', 'V_VP8']] as const; // by WebCodecs, in the file
const kMostWaiting = 3; // pictures in the encoder
const kKey_s = 1; // between pictures that stand for themselves

export interface Encoding {
  readonly config: VideoEncoderConfig;
  readonly codec: string; // as the file names it
}

/** How this browser encodes such a film; null: not at all. */
export async function encodingOf(settings: FilmSettings): Promise<Encoding | null> {
  if (typeof VideoEncoder === 'undefined') return null;
  const { size: [width, height], fps } = settings;
  for (const [name, codec] of kCodecs) {
    const config: VideoEncoderConfig = { codec: name, width, height, framerate: fps, bitrate: bitsPerSecond(settings), latencyMode: 'quality' };
    try {
      if ((await VideoEncoder.isConfigSupported(config)).supported) return { config, codec };
    } catch {
      // a name that it does not know
    }
  }
  return null;
}

class Encoder {
  private readonly encoder: VideoEncoder;
  private readonly chunks: EncodedVideoChunk[] = [];
  private error: Error | null = null;

  constructor(config: VideoEncoderConfig) {
    this.encoder = new VideoEncoder({ output: (chunk) => this.chunks.push(chunk), error: (error) => (this.error = error) });
    this.encoder.configure(config);
  }

  encode(frame: VideoFrame, keyFrame: boolean): void {
    try {
      if (this.error) throw this.error;
      this.encoder.encode(frame, { keyFrame });
    } finally {
      frame.close();
    }
  }

  /** Until there is room for another picture. */
  async ready(): Promise<void> {
    while (!this.error && this.encoder.encodeQueueSize > kMostWaiting) await new Promise((done) => this.encoder.addEventListener('dequeue', done, { once: true }));
  }

  async end(): Promise<EncodedVideoChunk[]> {
    await this.encoder.flush();
    if (this.error) throw this.error;
    return this.chunks;
  }

  close(): void {
    if (this.encoder.state !== 'closed') this.encoder.close();
  }
}

/** The colours of a picture that is seen through, and its opacity as the brightness of another. */
function splitAlpha({ data: pixels, width, height }: ImageData, timing: { timestamp: number; duration: number }): [VideoFrame, VideoFrame] {
  const chroma = Math.ceil(width / 2) * Math.ceil(height / 2);
  const planes = new Uint8Array(width * height + 2 * chroma).fill(128, width * height);
  for (let k = 0; k < width * height; ++k) planes[k] = pixels[4 * k + 3]!;
  const size = { codedWidth: width, codedHeight: height, ...timing };
  return [new VideoFrame(new Uint8Array(pixels), { format: 'RGBX', ...size }), new VideoFrame(planes, { format: 'I420', ...size })];
}

/** A moment for the page and its button to stop; not slowed down where the page is not seen, as timers are. */
function breath(): Promise<unknown> {
  return new Promise((done) => {
    const { port1, port2 } = new MessageChannel();
    port1.addEventListener('message', done, { once: true });
    port1.start();
    port2.postMessage(null);
  });
}

export async function encoded(film: Film, { config, codec }: Encoding, signal: AbortSignal, progress: (share: number) => void): Promise<Uint8Array> {
  const { pictures, settings } = film;
  const { fps, transparent, size: [width, height] } = settings;
  const pen = canvasOf(settings, transparent);
  const colours = new Encoder(config);
  const opacity = transparent ? new Encoder(config) : null;
  const time = (picture: number): number => Math.round((1e6 * picture) / fps); // µs
  try {
    for (let k = 0; k < pictures; ++k) {
      signal.throwIfAborted();
      film.draw(pen, k);
      const timing = { timestamp: time(k), duration: time(k + 1) - time(k) };
      const isKey = k % Math.round(kKey_s * fps) === 0;
      if (opacity) {
        const [colour, alpha] = splitAlpha(pen.getImageData(0, 0, width, height), timing);
        colours.encode(colour, isKey);
        opacity.encode(alpha, isKey);
        await opacity.ready();
      } else {
        colours.encode(new VideoFrame(pen.canvas, timing), isKey);
      }
      await colours.ready();
      progress((k + 1) / pictures);
      await breath();
    }
    const [chunks, alphas] = await Promise.all([colours.end(), opacity?.end()]);
    if (chunks.length !== pictures || (alphas && alphas.length !== pictures)) throw new Error('the browser left pictures of the film out');
    const bytesOf = (chunk: EncodedVideoChunk): Uint8Array => {
      const bytes = new Uint8Array(chunk.byteLength);
      chunk.copyTo(bytes);
      return bytes;
    };
    const all = chunks.map((chunk, k): Picture => ({
      time_s: k / fps, isKey: chunk.type === 'key', bytes: bytesOf(chunk), alpha: alphas ? bytesOf(alphas[k]!) : null,
    }));
    return webmFile({ codec, width, height, fps }, all);
  } finally {
    colours.close();
    opacity?.close();
  }
}
