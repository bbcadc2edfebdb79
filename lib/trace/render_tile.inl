// Tracing the pixels of a tile, included by one file for each instruction set, inside a namespace
// of its own.

namespace {

/// NoRecorder under a name that each instruction set has for itself, so that the linker does not
/// take one's code for the other's.
template <class T> struct Silent : NoRecorder<T> {};

/// The primary rays of 4 x 4 pixels are followed together, and their trees grown one by one.
constexpr int block = 4;

template <class T, Facts facts>
void trace_block(Tracer<T, Silent<T>, facts>& tracer, const World<T>& world,
                 const PictureTile& pixels, Picture& picture) {
    std::array<Query<T>, block * block> queries;
    std::array<Hit<T>, block * block> hits;
    std::size_t count = 0;
    for (int j = pixels.begin_j; j < pixels.end_j; ++j) {
        for (int i = pixels.begin_i; i < pixels.end_i; ++i) {
            queries[count++] = tracer.primary(i, j);
        }
    }
    world.shapes.closest(std::span(queries).first(count), std::span(hits).first(count),
                         Together::coherent);
    std::size_t k = 0;
    for (int j = pixels.begin_j; j < pixels.end_j; ++j) {
        for (int i = pixels.begin_i; i < pixels.end_i; ++i, ++k) {
            const std::size_t place = static_cast<std::size_t>(j) *
                                          static_cast<std::size_t>(picture.width) +
                                      static_cast<std::size_t>(i);
            picture.pixels[place] =
                rgb_cast<double>(tracer.trace_pixel(i, j, queries[k], &hits[k]));
        }
    }
}

template <class T, Facts facts>
void trace_tile(const World<T>& world, const PictureTile& tile, Picture& picture) {
    Silent<T> recorder;
    Tracer<T, Silent<T>, facts> tracer(world, recorder);
    for (int j = tile.begin_j; j < tile.end_j; j += block) {
        for (int i = tile.begin_i; i < tile.end_i; i += block) {
            trace_block(tracer, world,
                        {i, std::min(i + block, tile.end_i), j, std::min(j + block, tile.end_j)},
                        picture);
        }
    }
}

template <class T> TileTracer<T> choose_tile_tracer(const Plan& plan) {
    if (!plan.branches()) {
        return trace_tile<T, Facts{false, false, false}>;
    }
    if (!plan.transmissive && !plan.attenuated) {
        return trace_tile<T, Facts{true, false, false}>;
    }
    if (!plan.attenuated) {
        return trace_tile<T, Facts{true, true, false}>;
    }
    return trace_tile<T, Facts{}>;
}

}  // namespace
