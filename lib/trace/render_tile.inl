// Tracing the pixels of a tile, included by one file for each instruction set, inside a namespace
// of its own.

namespace {

/// NoRecorder under a name that each instruction set has for itself, so that the linker does not
/// take one's code for the other's.
template <class T> struct Silent : NoRecorder<T> {};

/// Traces 4 x 4 pixels at a time, the blocks of a tile one after the other. Their primary rays are
/// followed together, and so are those from what they hit to each light; then their trees are grown
/// one by one.
template <class T, Facts facts> class BlockTracer {
  public:
    static constexpr int side = 4;

    BlockTracer(const World<T>& world, Picture& picture)
        : world_(world),
          picture_(picture),
          tracer_(world, recorder_),
          asks_lights_(world.scene().settings.shadows == ShadowMode::opaque &&
                       !world.lights.empty()),
          lights_(asks_lights_ ? most * world.lights.size() : 0),
          hidden_(lights_.size()) {}

    /// A tile of any size. Where nothing lies in the space that its primary rays pass through, none
    /// is sent.
    void trace(const PictureTile& tile) {
        if (only_background(tile)) {
            for (int j = tile.begin_j; j < tile.end_j; ++j) {
                std::fill_n(&pixel(tile.begin_i, j), tile.end_i - tile.begin_i,
                            rgb_cast<double>(world_.background));
            }
            return;
        }
        const bool one_block =
            std::max(tile.end_i - tile.begin_i, tile.end_j - tile.begin_j) <= side;
        if (one_block) {
            trace_block(tile);
            return;
        }
        const auto middle = [](int begin, int end) {
            return std::min(end, begin + std::max(side, (end - begin + 1) / 2 / side * side));
        };
        const int i = middle(tile.begin_i, tile.end_i), j = middle(tile.begin_j, tile.end_j);
        for (const PictureTile& part : {PictureTile{tile.begin_i, i, tile.begin_j, j},
                                        PictureTile{i, tile.end_i, tile.begin_j, j},
                                        PictureTile{tile.begin_i, i, j, tile.end_j},
                                        PictureTile{i, tile.end_i, j, tile.end_j}}) {
            if (part.begin_i < part.end_i && part.begin_j < part.end_j) {
                trace(part);
            }
        }
    }

  private:
    static constexpr std::size_t most = side * side;

    Rgb<double>& pixel(int i, int j) {
        return picture_
            .pixels[static_cast<std::size_t>(j) * static_cast<std::size_t>(picture_.width) +
                    static_cast<std::size_t>(i)];
    }

    /// Whether all primary rays of a tile pass beside everything: by those at its corners, in
    /// double.
    bool only_background(const PictureTile& tile) const {
        if constexpr (std::same_as<T, double>) {
            const CameraRays<double>& camera = world_.camera;
            std::array<Query<double>, 4> corners;
            std::size_t k = 0;
            for (const int j : {tile.begin_j, tile.end_j - 1}) {
                for (const int i : {tile.begin_i, tile.end_i - 1}) {
                    Ray<double>& ray = corners[k++].ray;
                    ray = camera.primary(i, j);
                    ray.direction = camera.forward().vec() +
                                    along(Vec3<double>(camera.xp(i) * camera.right().vec()),
                                          camera.yp(j), camera.up());
                }
            }
            return !may_meet_between(world_.shapes.hierarchy(), corners);
        }
        return false;
    }

    void trace_block(const PictureTile& pixels) {
        count_ = 0;
        for (int j = pixels.begin_j; j < pixels.end_j; ++j) {
            for (int i = pixels.begin_i; i < pixels.end_i; ++i) {
                tracer_.primary(i, j, primary_[count_++]);
            }
        }
        world_.shapes.closest(std::span(primary_).first(count_), std::span(hits_).first(count_),
                              Together::coherent);
        for (std::size_t k = 0; k < count_; ++k) {
            answers_[k].query = &primary_[k];
            answers_[k].hit = hits_[k];
        }
        ask_lights();
        std::size_t k = 0;
        for (int j = pixels.begin_j; j < pixels.end_j; ++j) {
            for (int i = pixels.begin_i; i < pixels.end_i; ++i, ++k) {
                pixel(i, j) = rgb_cast<double>(tracer_.trace_pixel(i, j, answers_[k]));
            }
        }
    }

    void ask_lights() {
        const std::size_t lights = asks_lights_ ? world_.lights.size() : 0;
        for (std::size_t k = 0; k < count_; ++k) {
            PrimaryAnswer<T>& answer = answers_[k];
            if (answer.hit.primitive == no_primitive) {
                continue;
            }
            tracer_.find_surface(answer);
            answer.lights = std::span(lights_).subspan(k * lights, lights);
            answer.hidden = std::span(hidden_).subspan(k * lights, lights);
            for (std::size_t light = 0; light < lights; ++light) {
                answer.lights[light] =
                    illuminate(world_.lights[light], answer.surface->point, answer.normal);
            }
        }
        for (std::size_t light = 0; light < lights; ++light) {
            ask_light(light);
        }
    }

    void ask_light(std::size_t light) {
        std::size_t asked = 0;
        for (std::size_t k = 0; k < count_; ++k) {
            const PrimaryAnswer<T>& answer = answers_[k];
            const PrimitiveId shape = answer.hit.primitive;
            if (shape != no_primitive && tracer_.sends_shadow_ray(shape, answer.lights[light])) {
                tracer_.shadow_query(answer.surface->point, answer.front, shape,
                                     answer.lights[light], queries_[asked]);
                asked_of_[asked++] = k;
            }
        }
        world_.shapes.any(std::span(queries_).first(asked), std::span(met_).first(asked),
                          Together::coherent);
        for (std::size_t k = 0; k < asked; ++k) {
            answers_[asked_of_[k]].hidden[light] = met_[k];
        }
    }

    const World<T>& world_;
    Picture& picture_;
    Silent<T> recorder_;
    Tracer<T, Silent<T>, facts> tracer_;
    bool asks_lights_;
    std::vector<Illumination<T>> lights_;  ///< of each pixel's hit
    std::vector<std::uint8_t> hidden_;
    std::size_t count_ = 0;  ///< of the pixels
    std::array<Query<T>, most> primary_;
    std::array<Query<T>, most> queries_;  ///< from their hits to one light
    std::array<Hit<T>, most> hits_;
    std::array<PrimaryAnswer<T>, most> answers_;
    std::array<std::size_t, most> asked_of_;
    std::array<std::uint8_t, most> met_;
};

template <class T, Facts facts>
void trace_tile(const World<T>& world, const PictureTile& tile, Picture& picture) {
    BlockTracer<T, facts>(world, picture).trace(tile);
}

template <class T, ShapeFacts shapes> TileTracer<T> choose_by_branches(const Plan& plan) {
    if (!plan.branches()) {
        return trace_tile<T, Facts{false, false, false, shapes}>;
    }
    if (!plan.transmissive && !plan.attenuated) {
        return trace_tile<T, Facts{true, false, false, shapes}>;
    }
    if (!plan.attenuated) {
        return trace_tile<T, Facts{true, true, false, shapes}>;
    }
    return trace_tile<T, Facts{true, true, true, shapes}>;
}

template <class T> TileTracer<T> choose_tile_tracer(const Plan& plan) {
    if (plan.transforms) {
        return plan.interpolated_normals ? choose_by_branches<T, ShapeFacts{true, true}>(plan)
                                         : choose_by_branches<T, ShapeFacts{true, false}>(plan);
    }
    return plan.interpolated_normals ? choose_by_branches<T, ShapeFacts{false, true}>(plan)
                                     : choose_by_branches<T, ShapeFacts{false, false}>(plan);
}

}  // namespace
