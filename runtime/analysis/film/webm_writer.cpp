#include <fmt/format.h>
#include <vpx/vp8cx.h>
#include <vpx/vpx_encoder.h>

#include "runtime/analysis/film/film_writer.h"
#include "runtime/analysis/film/webm_file.h"
#include "runtime/analysis/film/yuv.h"
#include "runtime/base/user_error.h"

namespace runtime {
namespace {

constexpr int kVp9Quality = 24;  // of 0 (best) to 63
constexpr int kSpeed = 4;        // of 0 (slow) to 8

class WebmWriter : public FilmWriter {
 public:
  WebmWriter(int size, int pictures_per_second) : file_(size, pictures_per_second) {
    vpx_codec_enc_cfg_t settings;
    Check(vpx_codec_enc_config_default(vpx_codec_vp9_cx(), &settings, 0));
    settings.g_w = settings.g_h = static_cast<unsigned>(size);
    settings.g_timebase = {1, pictures_per_second};
    settings.rc_end_usage = VPX_Q;
    settings.kf_max_dist = kMostBetweenKeys;
    Check(vpx_codec_enc_init(&codec_, vpx_codec_vp9_cx(), &settings, 0));
    Check(vpx_codec_control(&codec_, VP8E_SET_CPUUSED, kSpeed));
    Check(vpx_codec_control(&codec_, VP8E_SET_CQ_LEVEL, kVp9Quality));
    Check(vpx_codec_control(&codec_, VP9E_SET_COLOR_SPACE, VPX_CS_BT_601));
    const auto side = static_cast<unsigned>(size);
    if (vpx_img_alloc(&image_, VPX_IMG_FMT_I420, side, side, 1) == nullptr) Fail("no memory");
  }
  WebmWriter(const WebmWriter&) = delete;
  WebmWriter& operator=(const WebmWriter&) = delete;
  ~WebmWriter() override {
    vpx_img_free(&image_);
    vpx_codec_destroy(&codec_);
  }

  void Add(const Image& picture) override {
    WriteYuv(picture, {PlaneOf(VPX_PLANE_Y), PlaneOf(VPX_PLANE_U), PlaneOf(VPX_PLANE_V)});
    Encode(&image_);
  }

  std::string Finish() override {
    while (Encode(nullptr)) {
    }
    return file_.Finish();
  }

 private:
  Plane PlaneOf(int index) const { return {image_.planes[index], image_.stride[index]}; }

  // Returns whether something came out. Null: what the encoder still has.
  bool Encode(const vpx_image_t* image) {
    Check(vpx_codec_encode(&codec_, image, next_, 1, 0, VPX_DL_GOOD_QUALITY));
    if (image != nullptr) ++next_;
    bool is_something = false;
    vpx_codec_iter_t iterator = nullptr;
    while (const vpx_codec_cx_pkt_t* packet = vpx_codec_get_cx_data(&codec_, &iterator)) {
      if (packet->kind != VPX_CODEC_CX_FRAME_PKT) continue;
      is_something = true;
      const auto& frame = packet->data.frame;
      file_.Add({static_cast<const char*>(frame.buf), frame.sz},
                (frame.flags & VPX_FRAME_IS_KEY) != 0);
    }
    return is_something;
  }

  void Check(vpx_codec_err_t result) const {
    if (result != VPX_CODEC_OK) Fail(vpx_codec_err_to_string(result));
  }
  [[noreturn]] static void Fail(const char* why) {
    throw UserError(fmt::format("cannot encode the film: {}", why));
  }

  WebmFile file_;
  vpx_codec_ctx_t codec_{};
  vpx_image_t image_{};
  vpx_codec_pts_t next_ = 0;
};

}  // namespace

std::unique_ptr<FilmWriter> MakeWebmWriter(int size, int pictures_per_second) {
  return std::make_unique<WebmWriter>(size, pictures_per_second);
}

}  // namespace runtime
