#include "runtime/training/run/compression.h"

#include <fmt/format.h>
#include <zstd.h>

#include <memory>

#include "runtime/base/user_error.h"

namespace runtime {
namespace {

constexpr int kLevel = 3;

struct FreeContext {
  void operator()(ZSTD_CCtx* context) const { ZSTD_freeCCtx(context); }
  void operator()(ZSTD_DCtx* context) const { ZSTD_freeDCtx(context); }
};

[[noreturn]] void ThrowDamaged(std::string_view what, std::string_view why) {
  throw UserError(fmt::format("{} is damaged: {}", what, why));
}

}  // namespace

std::string Compress(std::span<const std::byte> bytes) {
  const std::unique_ptr<ZSTD_CCtx, FreeContext> context(ZSTD_createCCtx());
  std::string compressed(ZSTD_compressBound(bytes.size()), '\0');
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_compressionLevel, kLevel);
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_checksumFlag, 1);
  const size_t size = ZSTD_compress2(context.get(), compressed.data(), compressed.size(),
                                     bytes.data(), bytes.size());
  if (ZSTD_isError(size) != 0) {
    throw UserError(fmt::format("cannot compress: {}", ZSTD_getErrorName(size)));
  }
  compressed.resize(size);
  return compressed;
}

// Piece by piece: a damaged header must not make us ask for all memory there is.
std::string Decompress(std::string_view compressed, std::string_view what) {
  const std::unique_ptr<ZSTD_DCtx, FreeContext> context(ZSTD_createDCtx());
  std::string bytes;
  std::string piece(ZSTD_DStreamOutSize(), '\0');
  ZSTD_inBuffer in{compressed.data(), compressed.size(), 0};
  size_t left = 1;  // until the frame is complete
  while (left != 0) {
    ZSTD_outBuffer out{piece.data(), piece.size(), 0};
    const size_t read_before = in.pos;
    left = ZSTD_decompressStream(context.get(), &out, &in);
    if (ZSTD_isError(left) != 0) ThrowDamaged(what, ZSTD_getErrorName(left));
    if (left != 0 && out.pos == 0 && in.pos == read_before) ThrowDamaged(what, "it is cut off");
    bytes.append(piece, 0, out.pos);
  }
  if (in.pos != in.size) ThrowDamaged(what, "there is something after it");
  return bytes;
}

}  // namespace runtime
