#include "state/picture.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <chrono>

#include "trace/tracer.h"
#include "tree/eight_bit.h"

namespace raytree::inspector {
namespace {

constexpr double most_cells = 6e6;
constexpr int coarsest_cells = 40;  // along the longer side of the first pass

int stride_of(const Camera& camera) {
    int stride = 1;
    while (static_cast<double>(camera.width) * camera.height / stride / stride > most_cells) {
        ++stride;
    }
    return stride;
}

std::uint32_t packed(const Rgb<double>& intensity, Quantize quantize) {
    std::uint32_t colour = 0xFF;
    for (const int value : eight_bit(intensity, quantize).value) {
        colour = colour << 8 | static_cast<std::uint32_t>(value);
    }
    return colour;
}

/// None where it is not finite.
std::optional<Rgb<double>> traced(const World<double>& world, int i, int j) {
    NoRecorder<double> recorder;
    try {
        return Tracer<double, NoRecorder<double>>(world, recorder).trace_pixel(i, j);
    } catch (const InputError&) {
        return std::nullopt;
    }
}

}  // namespace

PictureRender::PictureRender(std::shared_ptr<const Document> document, const ShownPicture* before,
                             const RightOfWay* window)
    : document_(std::move(document)), window_(window) {
    const Camera& camera = document_->scene().camera;
    picture_.stride = stride_of(camera);
    picture_.width = (camera.width - 1) / picture_.stride + 1;
    picture_.height = (camera.height - 1) / picture_.stride + 1;
    const std::size_t cells =
        static_cast<std::size_t>(picture_.width) * static_cast<std::size_t>(picture_.height);
    const bool same_size = before && before->width == picture_.width &&
                           before->height == picture_.height && before->cells.size() == cells;
    if (same_size) {
        picture_.cells = before->cells;
    } else {
        picture_.cells.assign(cells, packed(document_->scene().background, Quantize::round));
    }
    intensities_.resize(cells);
    thread_ = std::thread([this] { run(); });
}

PictureRender::~PictureRender() {
    cancel();
    thread_.join();
}

ShownPicture PictureRender::snapshot() const {
    const std::lock_guard lock(mutex_);
    return picture_;
}

std::optional<Rgb<double>> PictureRender::intensity(Pixel pixel) const {
    const int stride = picture_.stride;
    if (!document_->contains(pixel) || pixel.i % stride != 0 || pixel.j % stride != 0) {
        return std::nullopt;
    }
    const std::lock_guard lock(mutex_);
    return intensities_[place(pixel.i / stride, pixel.j / stride)];
}

/// Of many shapes the whole hierarchy is built, which cannot be cancelled: while one change follows
/// the other, as a slider's do, it is not begun.
void PictureRender::prepare() {
    constexpr std::size_t many = 10'000;
    constexpr auto settled = std::chrono::milliseconds(200);
    const auto& shapes = document_->world().shapes;
    const auto begin = std::chrono::steady_clock::now();
    while (shapes.shapes().size() >= many && !cancelled_ &&
           std::chrono::steady_clock::now() - begin < settled) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    if (!cancelled_) {
        shapes.complete();  // the first tree needs only a part, and does not wait
    }
}

void PictureRender::run() {
    // One core is left to the window.
    const int cores = static_cast<int>(std::thread::hardware_concurrency());
    tbb::task_arena arena(std::max(1, cores - 1));
    arena.execute([this] { render(); });
    done_ = !cancelled_;
    ++version_;
    stopped_ = true;
}

void PictureRender::render() {
    prepare();
    int step = 1;
    while (std::max(picture_.width, picture_.height) / step > coarsest_cells) {
        step *= 2;
    }
    for (bool first = true; step > 0 && !cancelled_; step /= 2, first = false) {
        run_pass(step, first);
    }
}

void PictureRender::run_pass(int step, bool first) {
    const int rows = (picture_.height - 1) / step + 1;
    tbb::parallel_for(0, rows, [&](int row) { run_row(row * step, step, first); });
}

/// Traces the cells of a row that earlier passes have not, and draws each as a square.
void PictureRender::run_row(int y, int step, bool first) {
    const bool has_earlier = !first && y % (2 * step) == 0;
    const int start = has_earlier ? step : 0;
    const int stride = has_earlier ? 2 * step : step;
    std::vector<std::optional<Rgb<double>>> row;
    for (int x = start; x < picture_.width; x += stride) {
        if (window_) {
            window_->give();
        }
        if (cancelled_) {
            return;
        }
        row.push_back(traced(document_->world(), x * picture_.stride, y * picture_.stride));
    }
    const Quantize quantize = document_->scene().settings.quantize;
    const std::lock_guard lock(mutex_);
    for (std::size_t k = 0; k < row.size(); ++k) {
        const int x = start + static_cast<int>(k) * stride;
        intensities_[place(x, y)] = row[k];
        fill_square(x, y, step, row[k] ? packed(*row[k], quantize) : not_finite_colour);
    }
    ++version_;
}

void PictureRender::fill_square(int x, int y, int side, std::uint32_t colour) {
    const int right = std::min(x + side, picture_.width);
    for (int below = y; below < std::min(y + side, picture_.height); ++below) {
        auto* const line = picture_.cells.data() + place(0, below);
        std::fill(line + x, line + right, colour);
    }
}

}  // namespace raytree::inspector
