// Little-endian float32 values as base64 text. Every browser's own order is little-endian, too.

/** The values that `text` encodes; throws where it is not whole values. */
export function decodeFloats(text: string): Float32Array {
  const binary = atob(text);
  if (binary.length % 4 !== 0) throw new Error("the page's data is cut off");
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; ++i) bytes[i] = binary.charCodeAt(i);
  return new Float32Array(bytes.buffer);
}
