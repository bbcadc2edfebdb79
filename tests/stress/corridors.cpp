#include "stress.h"
namespace raytree::stress {
Row corridors() {
    return {"corridors", "", "", "", "", 0, 0, 1, [](Random&, std::uint64_t) { return Tally{}; }};
}
}  // namespace raytree::stress
