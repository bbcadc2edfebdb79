#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <variant>
#include <vector>

#include "formats/measure_map.h"
#include "state/document.h"
#include "state/explained.h"
#include "state/right_of_way.h"
#include "trace/depth_picture.h"

namespace raytree::inspector {

/// What an overlay is of: a measure, or the depth picture beside the shadow rays of a light.
using OverlayOf = std::variant<Measure, lesson::DepthShown>;

/// Pixels that are of one kind where values are no amounts.
struct OverlayKind {
    std::string name;  ///< "max depth"
    Colour8 colour{};
    double value = 0;  ///< that such a pixel has
    std::size_t pixels = 0;
};

/// What is measured of each pixel, in colours: shown in the picture's place.
struct Overlay {
    OverlayOf of;
    int width = 0;
    int height = 0;
    std::vector<double> values;        ///< row by row from the top left
    std::vector<std::uint32_t> cells;  ///< 0xFFRRGGBB
    MapRange range;                    ///< of amounts
    std::vector<OverlayKind> kinds;    ///< of values that are none, the most frequent first

    /// Of a pixel in the picture.
    std::size_t place_of(Pixel pixel) const {
        return static_cast<std::size_t>(pixel.j) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(pixel.i);
    }
    double at(Pixel pixel) const { return values[place_of(pixel)]; }
    /// Null where values are amounts.
    const OverlayKind* kind_at(Pixel pixel) const;
};

Overlay make_overlay(Measurement measured, Measure measure);
Overlay make_overlay(const std::vector<ShadowAnswers>& answers, const Camera& camera,
                     const lesson::DepthShown& of);
/// "Rays in the pixel's tree, shadow rays too"
std::string title_of(const Overlay& overlay);
/// "23", "4.1 µs", "no intersection"
std::string value_text(const Overlay& overlay, Pixel pixel);
/// One end of the scale, with its unit.
std::string amount_text(const Overlay& overlay, double amount);
/// A reason's word, for people.
std::string plain_word(Reason reason);

/// Measures a document's picture in threads of its own.
class OverlayRender {
  public:
    /// Where there is a window, it goes first.
    OverlayRender(std::shared_ptr<const Document> document, OverlayOf of,
                  const RightOfWay* window = nullptr);
    /// Cancels, and waits for the trees that are just being traced.
    ~OverlayRender();

    double share() const { return share_.load(); }
    /// Whether its threads have come to an end, done or cancelled.
    bool stopped() const { return stopped_.load(); }
    void cancel() { cancelled_ = true; }

    /// Once stopped: null where it was cancelled or has failed.
    const std::shared_ptr<const Overlay>& overlay() const { return overlay_; }
    /// Once stopped: why there is none.
    const std::string& failure() const { return failure_; }

  private:
    void run();
    Overlay measured(Measure measure);
    Overlay compared(const lesson::DepthShown& depth) const;

    std::shared_ptr<const Document> document_;
    OverlayOf of_;
    const RightOfWay* window_;
    std::shared_ptr<const Overlay> overlay_;
    std::string failure_;
    std::atomic<double> share_{0};
    std::atomic<bool> cancelled_{false}, stopped_{false};
    std::thread thread_;
};

}  // namespace raytree::inspector
