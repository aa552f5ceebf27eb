#include <fmt/format.h>
#include <wels/codec_api.h>

#include <vector>

#include "runtime/analysis/film/film_writer.h"
#include "runtime/analysis/film/mp4_file.h"
#include "runtime/analysis/film/yuv.h"
#include "runtime/base/user_error.h"

namespace runtime {
namespace {

constexpr int kH264Quality = 23;  // of 0 (best) to 51

[[noreturn]] void FailToEncode(const char* why) {
  throw UserError(fmt::format("cannot encode the film: {}", why));
}

// The same bytes on every machine: one thread, and a quality that does not depend on the pictures
// before.
SEncParamExt SettingsFor(ISVCEncoder& encoder, int size, int pictures_per_second) {
  SEncParamExt settings;
  encoder.GetDefaultParams(&settings);
  settings.iUsageType = CAMERA_VIDEO_REAL_TIME;
  settings.iPicWidth = settings.iPicHeight = size;
  settings.fMaxFrameRate = static_cast<float>(pictures_per_second);
  settings.iRCMode = RC_OFF_MODE;
  settings.iComplexityMode = HIGH_COMPLEXITY;
  settings.uiIntraPeriod = kMostBetweenKeys;
  settings.eSpsPpsIdStrategy = CONSTANT_ID;
  settings.iEntropyCodingModeFlag = 1;
  settings.iMultipleThreadIdc = 1;
  settings.bEnableFrameSkip = false;
  settings.bEnableSceneChangeDetect = false;
  settings.bEnableBackgroundDetection = false;
  settings.bEnableAdaptiveQuant = false;
  SSpatialLayerConfig& layer = settings.sSpatialLayers[0];
  layer.iVideoWidth = layer.iVideoHeight = size;
  layer.fFrameRate = settings.fMaxFrameRate;
  layer.iDLayerQp = kH264Quality;
  layer.uiProfileIdc = PRO_HIGH;
  layer.sSliceArgument.uiSliceMode = SM_SINGLE_SLICE;
  return settings;
}

class Mp4Writer : public FilmWriter {
 public:
  Mp4Writer(int size, int pictures_per_second)
      : size_(size),
        pictures_per_second_(pictures_per_second),
        file_(size, pictures_per_second),
        bytes_(static_cast<size_t>(size) * static_cast<size_t>(size) * 3 / 2) {
    if (WelsCreateSVCEncoder(&encoder_) != 0 || encoder_ == nullptr) FailToEncode("no encoder");
    int trace = WELS_LOG_QUIET;
    encoder_->SetOption(ENCODER_OPTION_TRACE_LEVEL, &trace);
    const SEncParamExt settings = SettingsFor(*encoder_, size, pictures_per_second);
    if (encoder_->InitializeExt(&settings) != cmResultSuccess) {
      WelsDestroySVCEncoder(encoder_);
      FailToEncode("the encoder refuses its size");
    }
    FillSource();
  }
  Mp4Writer(const Mp4Writer&) = delete;
  Mp4Writer& operator=(const Mp4Writer&) = delete;
  ~Mp4Writer() override {
    encoder_->Uninitialize();
    WelsDestroySVCEncoder(encoder_);
  }

  void Add(const Image& picture) override {
    WriteYuv(picture, {{source_.pData[0], source_.iStride[0]},
                       {source_.pData[1], source_.iStride[1]},
                       {source_.pData[2], source_.iStride[2]}});
    source_.uiTimeStamp = next_++ * 1000 / pictures_per_second_;
    SFrameBSInfo encoded{};
    if (encoder_->EncodeFrame(&source_, &encoded) != cmResultSuccess) {
      FailToEncode("the encoder has failed");
    }
    std::string units;
    for (int i = 0; i < encoded.iLayerNum; ++i) {
      const SLayerBSInfo& layer = encoded.sLayerInfo[i];
      size_t size = 0;
      for (int k = 0; k < layer.iNalCount; ++k) {
        size += static_cast<size_t>(layer.pNalLengthInByte[k]);
      }
      units.append(reinterpret_cast<const char*>(layer.pBsBuf), size);
    }
    file_.Add(units, encoded.eFrameType == videoFrameTypeIDR);
  }

  std::string Finish() override { return file_.Finish(); }

 private:
  void FillSource() {
    const size_t pixels = static_cast<size_t>(size_) * static_cast<size_t>(size_);
    source_.iColorFormat = videoFormatI420;
    source_.iPicWidth = source_.iPicHeight = source_.iStride[0] = size_;
    source_.iStride[1] = source_.iStride[2] = size_ / 2;
    source_.pData[0] = bytes_.data();
    source_.pData[1] = bytes_.data() + pixels;
    source_.pData[2] = bytes_.data() + pixels + pixels / 4;
  }

  int size_;
  int pictures_per_second_;
  Mp4File file_;
  std::vector<uint8_t> bytes_;  // of the picture that is encoded
  SSourcePicture source_{};     // the same
  ISVCEncoder* encoder_ = nullptr;
  int64_t next_ = 0;
};

}  // namespace

std::unique_ptr<FilmWriter> MakeMp4Writer(int size, int pictures_per_second) {
  return std::make_unique<Mp4Writer>(size, pictures_per_second);
}

}  // namespace runtime
