#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "state/document.h"
#include "state/right_of_way.h"

namespace raytree::inspector {

/// A picture of 8-bit colours, 0xFFRRGGBB, row by row from the top left. Very large pictures are
/// shown thinned out: cell (x, y) is pixel (x stride, y stride).
struct ShownPicture {
    int width = 0;  ///< in cells
    int height = 0;
    int stride = 1;
    std::vector<std::uint32_t> cells;
};

/// Marks a pixel whose intensity is not a finite number.
inline constexpr std::uint32_t not_finite_colour = 0xFFFF00FF;

/// Renders a document's picture, coarse to fine, in threads of its own. Every pixel is traced once:
/// a coarse picture's pixels are those of the final one, drawn as squares.
class PictureRender {
  public:
    /// Where there is a picture of the same size before, it is what is seen at first. Where there
    /// is a window, it goes first.
    explicit PictureRender(std::shared_ptr<const Document> document,
                           const ShownPicture* before = nullptr,
                           const RightOfWay* window = nullptr);
    /// Cancels, and waits for the trees that are just being traced.
    ~PictureRender();

    /// Goes up with all that is added to the picture.
    std::uint64_t version() const { return version_.load(); }
    ShownPicture snapshot() const;
    /// Of a pixel that has been traced.
    std::optional<Rgb<double>> intensity(Pixel pixel) const;
    bool done() const { return done_.load(); }

    void cancel() { cancelled_ = true; }
    /// Whether its threads have come to an end, done or cancelled.
    bool stopped() const { return stopped_.load(); }

  private:
    void run();
    void render();
    void prepare();
    void run_pass(int step, bool first);
    void run_row(int y, int step, bool first);
    void fill_square(int x, int y, int side, std::uint32_t colour);
    std::size_t place(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(picture_.width) +
               static_cast<std::size_t>(x);
    }

    std::shared_ptr<const Document> document_;
    const RightOfWay* window_;
    mutable std::mutex mutex_;
    ShownPicture picture_;                                 ///< guarded by mutex_
    std::vector<std::optional<Rgb<double>>> intensities_;  ///< of cells; guarded by mutex_
    std::atomic<std::uint64_t> version_{0};
    std::atomic<bool> done_{false}, cancelled_{false}, stopped_{false};
    std::thread thread_;
};

}  // namespace raytree::inspector
