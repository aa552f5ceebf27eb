// Bytes, and little-endian float32 values, as base64 text. Every browser's own order is
// little-endian, too.

export function decodeBytes(text: string): Uint8Array {
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

/** The values that `text` encodes; throws where it is not whole values. */
export function decodeFloats(text: string): Float32Array {
  const bytes = decodeBytes(text);
  if (bytes.length % 4 !== 0) throw new Error("the page's data is cut off");
  return new Float32Array(bytes.buffer as ArrayBuffer);
}
