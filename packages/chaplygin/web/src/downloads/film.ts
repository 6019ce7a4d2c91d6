/** A motion as a film, encoded by the browser. */

import { BufferTarget, EncodedPacket, EncodedVideoPacketSource, Mp4OutputFormat, Output, type VideoCodec } from "mediabunny";

/** Pictures a second. */
const RATE = 30;

/** Codecs to try, best known first: H.264 plays everywhere, VP9 where a browser may not write the former. */
const CODECS: readonly { codec: string; kind: VideoCodec }[] = [
  { codec: "avc1.640028", kind: "avc" },
  { codec: "avc1.42001f", kind: "avc" },
  { codec: "vp09.00.41.08", kind: "vp9" },
  { codec: "av01.0.08M.08", kind: "av1" },
];

/** What a film shows. */
export interface FilmPlan {
  width: number;
  height: number;
  /** Seconds that it lasts. */
  duration: number;
  /** The picture at an instant of the film. */
  picture(seconds: number): CanvasImageSource | Promise<CanvasImageSource>;
  progress(share: number): void;
  /** Whether to go on. */
  wanted(): boolean;
}

/** Encode a film as an MP4 file; a message where this browser cannot, or where it was stopped. */
export async function film(plan: FilmPlan): Promise<Blob | { message: string }> {
  if (typeof VideoEncoder === "undefined") return { message: "This browser cannot write films; a picture and a 3D file can be had." };
  const [width, height] = [even(plan.width), even(plan.height)];
  const chosen = await firstSupported(width, height);
  if (chosen === null) return { message: "This browser has no encoder for films of this size." };
  const target = new BufferTarget();
  const output = new Output({ format: new Mp4OutputFormat(), target });
  const track = new EncodedVideoPacketSource(chosen.kind);
  output.addVideoTrack(track, { frameRate: RATE });
  await output.start();
  let failure: Error | null = null;
  let adding = Promise.resolve();
  const encoder = new VideoEncoder({
    output: (chunk, notes) => {
      adding = adding.then(() => track.add(EncodedPacket.fromEncodedChunk(chunk), notes));
    },
    error: (why) => (failure = why),
  });
  encoder.configure(chosen.config);
  const count = Math.max(1, Math.round(plan.duration * RATE));
  for (let n = 0; n < count && failure === null; n++) {
    if (!plan.wanted()) {
      encoder.close();
      await output.cancel();
      return { message: "The film was stopped." };
    }
    const frame = new VideoFrame(await plan.picture(n / RATE), { timestamp: Math.round((n * 1e6) / RATE), duration: Math.round(1e6 / RATE) });
    encoder.encode(frame, { keyFrame: n % 60 === 0 });
    frame.close();
    plan.progress((n + 1) / count);
    while (encoder.encodeQueueSize > 4) await new Promise((resolve) => setTimeout(resolve, 4));
  }
  if (failure === null) await encoder.flush();
  await adding;
  if (failure !== null) return { message: `The browser's encoder failed: ${(failure as Error).message}.` };
  await output.finalize();
  return new Blob([target.buffer ?? new ArrayBuffer(0)], { type: "video/mp4" });
}

async function firstSupported(width: number, height: number): Promise<{ kind: VideoCodec; config: VideoEncoderConfig } | null> {
  for (const { codec, kind } of CODECS) {
    const config: VideoEncoderConfig = { codec, width, height, bitrate: 8 * width * height, framerate: RATE };
    if (kind === "avc") config.avc = { format: "avc" };
    const answer = await VideoEncoder.isConfigSupported(config).catch(() => null);
    if (answer?.supported === true) return { kind, config };
  }
  return null;
}

/** Encoders want even sides. */
function even(side: number): number {
  return 2 * Math.max(1, Math.round(side / 2));
}
