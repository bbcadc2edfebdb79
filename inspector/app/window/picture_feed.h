#pragma once

#include <QImage>
#include <QObject>
#include <QTimer>
#include <memory>
#include <vector>

#include "state/overlay.h"
#include "state/picture.h"
#include "state/right_of_way.h"
#include "state/state.h"

namespace raytree::inspector {

/// The picture of the open scene as it comes in, for all panes that show it.
class PictureFeed : public QObject {
    Q_OBJECT

  public:
    explicit PictureFeed(State& state, QObject* parent = nullptr);
    ~PictureFeed() override { way_->leave(); }

    const ShownPicture& picture() const { return picture_; }
    bool done() const {
        return render_ && render_->done() && version_ == render_->version() && !measuring_;
    }
    std::optional<Rgb<double>> intensity(Pixel pixel) const;
    /// The overlay that is asked for; null until it has come.
    const std::shared_ptr<const Overlay>& overlay() const { return overlay_; }
    /// Whether one is asked for.
    bool overlaid() const { return measure_.has_value(); }
    double overlay_share() const { return measuring_ ? measuring_->share() : 0; }
    bool overlay_failed() const { return overlay_failed_; }
    /// Over the work that brings the picture in.
    const std::shared_ptr<RightOfWay>& right_of_way() const { return way_; }

  Q_SIGNALS:
    void updated();

  private:
    void restart();
    void measure();
    void poll();
    void poll_overlay();

    State& state_;
    std::shared_ptr<RightOfWay> way_ = std::make_shared<RightOfWay>();  ///< over the work below
    std::unique_ptr<PictureRender> render_;
    std::vector<std::unique_ptr<PictureRender>> ending_;  ///< cancelled, not yet at their end
    std::unique_ptr<OverlayRender> measuring_;            ///< null when it is done
    std::vector<std::unique_ptr<OverlayRender>> ending_overlays_;
    std::shared_ptr<const Overlay> overlay_;
    std::optional<OverlayOf> measure_;  ///< of what overlay_ is or will be
    bool overlay_failed_ = false;
    ShownPicture picture_;
    std::uint64_t version_ = 0;
    QTimer timer_;
};

}  // namespace raytree::inspector
