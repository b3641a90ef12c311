// Box2D 2.3 in C++ as one implementation of `make bench`: box2d rollouts|worlds FILE
//
// Builds the worlds of FILE, which `cargo bench --bench simulator -- export FILE` writes, with PHYRE's parameters. Prints the
// end of each rollout, which the other implementations have to agree with, and then reads a number of repetitions per line of
// standard input and prints the milliseconds of each: of stepping alone, or of making and deleting the worlds.

#include <Box2D/Box2D.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace {

struct ShapeDefinition {
    // px; 0 for a polygon.
    double radius;
    // px.
    std::vector<std::pair<double, double>> corners;
};

struct BodyDefinition {
    bool dynamic;
    // px and radians.
    double x, y, angle;
    std::vector<ShapeDefinition> shapes;
};

struct RolloutDefinition {
    int object, goal;
    // If both are balls: they touch when their centres are nearer than this, px; else 0.
    double touchDistance;
    std::vector<BodyDefinition> bodies;
};

// The first line of the file.
struct Parameters {
    int maxSteps, goalSteps, velocityIterations, positionIterations;
    double pxPerMetre, timeStep, gravity, density, friction, restitution, angularDamping;
};

struct Input {
    Parameters parameters;
    std::vector<RolloutDefinition> rollouts;
};

Input read(const char* path) {
    std::ifstream file(path);
    Input input;
    Parameters& p = input.parameters;
    file >> p.maxSteps >> p.goalSteps >> p.velocityIterations >> p.positionIterations >> p.pxPerMetre >> p.timeStep >>
        p.gravity >> p.density >> p.friction >> p.restitution >> p.angularDamping;
    RolloutDefinition rollout;
    size_t bodies;
    while (file >> rollout.object >> rollout.goal >> rollout.touchDistance >> bodies) {
        rollout.bodies.assign(bodies, {});
        for (BodyDefinition& body : rollout.bodies) {
            size_t shapes;
            file >> body.dynamic >> body.x >> body.y >> body.angle >> shapes;
            body.shapes.resize(shapes);
            for (ShapeDefinition& shape : body.shapes) {
                size_t corners;
                file >> shape.radius >> corners;
                shape.corners.resize(corners);
                for (auto& [x, y] : shape.corners) file >> x >> y;
            }
        }
        input.rollouts.push_back(rollout);
    }
    if (!file.eof() || input.rollouts.empty()) {
        std::cerr << path << " does not hold rollouts: write it with `cargo bench --bench simulator -- export FILE`\n";
        std::exit(1);
    }
    return input;
}

struct Rollout {
    const Parameters& parameters;
    const RolloutDefinition& definition;
    b2World world;
    std::vector<b2Body*> bodies;

    Rollout(const Parameters& parameters, const RolloutDefinition& definition)
        : parameters(parameters), definition(definition), world(b2Vec2(0.0f, parameters.gravity)) {
        auto metres = [&](double x, double y) { return b2Vec2(x / parameters.pxPerMetre, y / parameters.pxPerMetre); };
        for (const BodyDefinition& from : definition.bodies) {
            b2BodyDef body;
            body.type = from.dynamic ? b2_dynamicBody : b2_staticBody;
            body.position = metres(from.x, from.y);
            body.angle = from.angle;
            body.angularDamping = parameters.angularDamping;
            bodies.push_back(world.CreateBody(&body));
            for (const ShapeDefinition& shape : from.shapes) {
                b2CircleShape circle;
                b2PolygonShape polygon;
                std::vector<b2Vec2> corners;
                for (auto [x, y] : shape.corners) corners.push_back(metres(x, y));
                circle.m_radius = shape.radius / parameters.pxPerMetre;
                if (!corners.empty()) polygon.Set(corners.data(), corners.size());
                b2FixtureDef fixture;
                fixture.shape = corners.empty() ? static_cast<b2Shape*>(&circle) : &polygon;
                fixture.density = parameters.density;
                fixture.friction = parameters.friction;
                fixture.restitution = parameters.restitution;
                bodies.back()->CreateFixture(&fixture);
            }
        }
    }

    bool touches() const {
        const b2Body *object = bodies[definition.object], *goal = bodies[definition.goal];
        if (definition.touchDistance > 0.0) {
            const b2Vec2 delta = object->GetPosition() - goal->GetPosition();
            return std::hypot(double(delta.x), double(delta.y)) * parameters.pxPerMetre < definition.touchDistance;
        }
        for (const b2ContactEdge* edge = object->GetContactList(); edge; edge = edge->next) {
            if (edge->other == goal && edge->contact->IsTouching()) return true;
        }
        return false;
    }

    bool awake() const {
        for (const b2Body* body : bodies) {
            if (body->GetType() == b2_dynamicBody && body->IsAwake()) return true;
        }
        return false;
    }

    // Steps until the task is solved or the steps are over, as PHYRE does. Skips the steps in which all bodies sleep, as
    // ours does. Returns the number of steps.
    int run(bool& solved) {
        int touchSteps = 0;
        solved = false;
        for (int step = 1; step <= parameters.maxSteps; ++step) {
            if (awake()) world.Step(parameters.timeStep, parameters.velocityIterations, parameters.positionIterations);
            touchSteps = touches() ? touchSteps + 1 : 0;
            if (touchSteps == parameters.goalSteps) {
                solved = true;
                return step;
            }
        }
        return parameters.maxSteps;
    }
};

// Prints [solved, steps, x and y of each dynamic body in px] for each rollout.
void printFinalStates(const Input& input) {
    std::ostringstream line;
    line.precision(9);
    line << "[";
    for (const RolloutDefinition& definition : input.rollouts) {
        auto rollout = std::make_unique<Rollout>(input.parameters, definition);
        bool solved;
        const int steps = rollout->run(solved);
        line << (line.tellp() > 1 ? ", [" : "[") << solved << ", " << steps;
        for (const b2Body* body : rollout->bodies) {
            if (body->GetType() != b2_dynamicBody) continue;
            const b2Vec2 at = input.parameters.pxPerMetre * body->GetPosition();
            line << ", " << at.x << ", " << at.y;
        }
        line << "]";
    }
    std::cout << line.str() << "]" << std::endl;
}

using Clock = std::chrono::steady_clock;

double milliseconds(Clock::duration duration) { return std::chrono::duration<double, std::milli>(duration).count(); }

// The milliseconds of stepping all rollouts, or of making and deleting their worlds.
double repeat(const Input& input, bool stepping) {
    Clock::duration stepped{};
    const auto start = Clock::now();
    for (const RolloutDefinition& definition : input.rollouts) {
        auto rollout = std::make_unique<Rollout>(input.parameters, definition);
        if (!stepping) continue;
        bool solved;
        const auto start = Clock::now();
        rollout->run(solved);
        stepped += Clock::now() - start;
    }
    return milliseconds(stepping ? stepped : Clock::now() - start);
}

}  // namespace

int main(int count, char** arguments) {
    const std::string what = count == 3 ? arguments[1] : "";
    if (what != "rollouts" && what != "worlds") {
        std::cerr << "usage: box2d rollouts|worlds FILE\n";
        return 2;
    }
    const Input input = read(arguments[2]);
    printFinalStates(input);
    for (int repetitions; std::cin >> repetitions;) {
        std::cout << "[";
        for (int done = 0; done < repetitions; ++done) std::cout << (done ? ", " : "") << repeat(input, what == "rollouts");
        std::cout << "]" << std::endl;
    }
}
