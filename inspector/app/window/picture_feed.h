#pragma once

#include <QImage>
#include <QObject>
#include <QTimer>
#include <memory>
#include <vector>

#include "state/picture.h"
#include "state/state.h"

namespace raytree::inspector {

/// The picture of the open scene as it comes in, for all panes that show it.
class PictureFeed : public QObject {
    Q_OBJECT

  public:
    explicit PictureFeed(State& state, QObject* parent = nullptr);

    const ShownPicture& picture() const { return picture_; }
    bool done() const { return render_ && render_->done() && version_ == render_->version(); }
    std::optional<Rgb<double>> intensity(Pixel pixel) const;

  Q_SIGNALS:
    void updated();

  private:
    void restart();
    void poll();

    State& state_;
    std::unique_ptr<PictureRender> render_;
    std::vector<std::unique_ptr<PictureRender>> ending_;  ///< cancelled, not yet at their end
    ShownPicture picture_;
    std::uint64_t version_ = 0;
    QTimer timer_;
};

}  // namespace raytree::inspector
