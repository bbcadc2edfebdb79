#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "formats/measure_map.h"
#include "state/document.h"

namespace raytree::inspector {

/// What is measured of each pixel, in colours: shown in the picture's place.
struct Overlay {
    Measure measure = Measure::rays;
    int width = 0;
    int height = 0;
    std::vector<double> values;        ///< row by row from the top left
    std::vector<std::uint32_t> cells;  ///< 0xFFRRGGBB
    MapRange range;
    std::vector<ReasonPixels> reasons;  ///< of Measure::ended, the most frequent first

    /// Of a pixel in the picture.
    double at(Pixel pixel) const {
        return values[static_cast<std::size_t>(pixel.j) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(pixel.i)];
    }
};

Overlay make_overlay(Measurement measured, Measure measure);
/// "23", "4.1 µs", "no intersection"
std::string value_text(const Overlay& overlay, Pixel pixel);
/// A reason's word, for people.
std::string plain_word(Reason reason);

/// Measures a document's picture in threads of its own.
class OverlayRender {
  public:
    OverlayRender(std::shared_ptr<const Document> document, Measure measure);
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

    std::shared_ptr<const Document> document_;
    Measure measure_;
    std::shared_ptr<const Overlay> overlay_;
    std::string failure_;
    std::atomic<double> share_{0};
    std::atomic<bool> cancelled_{false}, stopped_{false};
    std::thread thread_;
};

}  // namespace raytree::inspector
