// The smallest tracer that records: the two balls of ../sample-scene.json.
//     g++ -std=c++17 sample.cpp -o sample && ./sample 16 12 > tree.json
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "raytree_recorder.h"

struct Vec {
    double x, y, z;
};
static Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
static Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
static Vec operator*(double s, Vec a) { return {s * a.x, s * a.y, s * a.z}; }
static double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static Vec unit(Vec a) { return 1 / std::sqrt(dot(a, a)) * a; }

struct Ball {
    const char* name;
    Vec centre;
    double radius;
    Vec colour;
    double ka, kd, kr;
};
static const Ball balls[] = {{"ball", {0, 0, 0}, 1, {0.9, 0.9, 0.9}, 0.1, 0.3, 0.6},
                             {"small", {1.2, 0.8, 0.8}, 0.4, {0.8, 0.4, 0.2}, 0.2, 0.7, 0.1}};
static const Vec background{0.1, 0.2, 0.3}, lamp{3, 5, 4};

static const Ball* nearest(Vec origin, Vec direction, double& t) {
    const Ball* found = nullptr;
    for (const Ball& ball : balls) {
        const Vec to = origin - ball.centre;
        const double b = dot(to, direction);
        const double root = b * b - dot(to, to) + ball.radius * ball.radius;
        if (root < 0)
            continue;
        for (const double s : {-b - std::sqrt(root), -b + std::sqrt(root)}) {
            if (s > 1e-6 && s < t) {
                t = s;
                found = &ball;
            }
        }
    }
    return found;
}

static Vec trace(raytree::Recorder& recorder, const char* kind, int parent, Vec origin,
                 Vec direction, int level) {
    auto ray = recorder.ray(kind, parent, origin, direction);
    double t = 1e30;
    const Ball* ball = nearest(origin, direction, t);
    if (!ball) {
        ray.miss().set("intensity", background);
        return background;
    }
    const Vec point = origin + t * direction;
    const Vec normal = 1 / ball->radius * (point - ball->centre);
    Vec sum = ball->ka * ball->colour;
    const double distance = std::sqrt(dot(lamp - point, lamp - point));
    const Vec towards = unit(lamp - point);
    if (dot(normal, towards) > 0) {
        double until = distance;
        const Ball* between = nearest(point, towards, until);
        auto shadow = recorder.shadow(ray.id, "lamp", point, towards);
        between ? shadow.blocked_by(between->name) : shadow.reaches_light();
        if (!between)
            sum = sum + ball->kd * dot(normal, towards) * ball->colour;
    }
    if (level < 4) {
        const Vec mirrored = unit(direction - 2 * dot(direction, normal) * normal);
        sum = sum + ball->kr * trace(recorder, "reflected", ray.id, point, mirrored, level + 1);
    }
    ray.hit(ball->name, t).at_hit("normal", normal).set("intensity", sum);
    return sum;
}

int main(int argc, char** argv) {
    const int i = argc > 2 ? std::atoi(argv[1]) : 16, j = argc > 2 ? std::atoi(argv[2]) : 12;
    raytree::Recorder recorder(i, j);
    const Vec direction{-0.4 + (i + 0.5) * 0.8 / 32, 0.3 - (j + 0.5) * 0.6 / 24, -1};
    trace(recorder, "primary", raytree::no_parent, {0, 0, 5}, unit(direction), 1);
    std::fputs(recorder.json().c_str(), stdout);
}
