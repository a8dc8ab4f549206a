// Algorithm 1 in C++20: the exploration is one coroutine that reads as the paper does.
//
//     allworlds init --header > allworlds.h
//     c++ -std=c++20 -O2 -shared -fPIC -I . -o algorithm1.so examples/cpp/algorithm1.cpp
//     allworlds check --native ./algorithm1.so --edges 6
//
// No exception may leave the library: whatever is thrown in the coroutine ends the process.
#include <allworlds.h>

#include <algorithm>
#include <coroutine>
#include <deque>
#include <exception>
#include <memory>
#include <utility>
#include <vector>

namespace {

using Percept = allworlds_percept;

bool alike(const Percept &a, const Percept &b)
{
    return a.degree == b.degree && a.marks == b.marks && a.bearing == b.bearing;
}

// The paper's S and U.  The darts of a vertex are consecutive and clockwise.
struct PartialMap {
    struct Dart {
        int twin; // itself: nobody knows yet where it leads
        int vertex;
        Percept expected; // of a robot that has arrived by it
    };
    std::vector<Dart> darts;
    std::vector<int> first; // of each vertex
    std::vector<int> open;  // U, in the order in which its darts came into S

    int vertex(int dart) const { return darts[dart].vertex; }
    int degree(int dart) const { return darts[dart].expected.degree; }

    int turned(int dart, int motion) const
    {
        const int start = first[vertex(dart)], n = degree(dart);
        return start + ((dart - start + motion) % n + n) % n;
    }

    int add_vertex(Percept seen)
    {
        const int start = static_cast<int>(darts.size());
        for (int dart = start; dart < start + seen.degree; dart++) {
            darts.push_back({dart, static_cast<int>(first.size()), seen});
            open.push_back(dart);
        }
        first.push_back(start);
        return start;
    }

    void explore(int dart, int partner)
    {
        darts[dart].twin = partner;
        darts[partner].twin = dart;
        std::erase_if(open, [=](int other) { return other == dart || other == partner; });
    }

    // For each vertex the length of a shortest walk to the goal.
    std::vector<int> lengths(int goal) const
    {
        std::vector<int> length(first.size(), -1);
        std::deque<int> queue{goal};
        length[goal] = 0;
        while (!queue.empty()) {
            const int v = queue.front();
            queue.pop_front();
            for (int dart = first[v]; dart < first[v] + degree(first[v]); dart++) {
                const int w = vertex(darts[dart].twin);
                if (length[w] < 0) {
                    length[w] = length[v] + 1;
                    queue.push_back(w);
                }
            }
        }
        return length;
    }

    // The darts by which a shortest walk leaves its vertices.
    std::vector<int> path(int start, int goal) const
    {
        const auto length = lengths(goal);
        std::vector<int> taken;
        for (int v = start; v != goal; v = vertex(darts[taken.back()].twin)) {
            int dart = first[v];
            while (length[vertex(darts[dart].twin)] != length[v] - 1)
                dart++;
            taken.push_back(dart);
        }
        return taken;
    }
};

// A coroutine that says what the robot does, and is told what it senses.
class Exploration {
public:
    struct promise_type {
        allworlds_action said{};
        Percept sensed{};

        Exploration get_return_object()
        {
            return Exploration{std::coroutine_handle<promise_type>::from_promise(*this)};
        }
        std::suspend_always initial_suspend() noexcept { return {}; }
        std::suspend_always final_suspend() noexcept { return {}; }
        void return_void() { said.kind = ALLWORLDS_ANSWER; }
        void unhandled_exception() { std::terminate(); }

        auto yield_value(allworlds_action action)
        {
            said = action;
            struct Awaiter : std::suspend_always {
                promise_type *promise;
                Percept await_resume() const { return promise->sensed; }
            };
            return Awaiter{{}, this};
        }
    };

    explicit Exploration(std::coroutine_handle<promise_type> handle) : handle_(handle) {}
    Exploration(Exploration &&other) noexcept : handle_(std::exchange(other.handle_, nullptr)) {}
    Exploration(const Exploration &) = delete;
    Exploration &operator=(const Exploration &) = delete;
    Exploration &operator=(Exploration &&) = delete;
    ~Exploration()
    {
        if (handle_)
            handle_.destroy();
    }

    allworlds_action go_on(Percept sensed)
    {
        handle_.promise().sensed = sensed;
        handle_.resume();
        return handle_.promise().said;
    }

private:
    std::coroutine_handle<promise_type> handle_;
};

allworlds_action move_by(int motion) { return {ALLWORLDS_MOVE, motion}; }

struct Robot {
    PartialMap s;
    int here = 0; // between two passes: the robot's dart in S
    allworlds_pick pick = nullptr;
    void *context = nullptr;
    std::unique_ptr<Exploration> exploration;

    int choose(int of, const std::vector<int> &options, const std::vector<int> &cost)
    {
        if (!pick)
            return 0;
        return pick(context, of, static_cast<int>(options.size()), cost.data());
    }

    int take_from_u() // lines 2-3
    {
        const auto length = s.lengths(s.vertex(here));
        std::vector<int> cost;
        for (int dart : s.open)
            cost.push_back(length[s.vertex(dart)]);
        return s.open[choose(ALLWORLDS_EDGE, s.open, cost)];
    }

    Exploration explore(Percept first)
    {
        s.add_vertex(first); // line 1
        for (int dart = 0; dart < first.degree; dart++)
            if (first.bearing >= 0)
                s.darts[dart].expected.bearing = (first.bearing - dart + first.degree) % first.degree;
        while (!s.open.empty()) {
            const int goal = take_from_u();
            int at = here;
            for (int dart : s.path(s.vertex(at), s.vertex(goal))) { // line 4
                co_yield move_by(dart - at);
                at = s.darts[dart].twin;
            }
            const Percept seen = co_yield move_by(goal - at); // line 5
            std::vector<int> hypotheses;                      // line 6
            for (int dart : s.open)
                if (dart != goal && alike(s.darts[dart].expected, seen))
                    hypotheses.push_back(dart);
            int turned = 0;
            bool confirmed = false;
            while (!hypotheses.empty() && !confirmed) { // lines 7-8
                const auto length = s.lengths(0);
                std::vector<int> cost;
                for (int dart : hypotheses)
                    cost.push_back(length[s.vertex(dart)]);
                const int index = choose(ALLWORLDS_HYPOTHESIS, hypotheses, cost);
                const int partner = hypotheses[index];
                hypotheses.erase(hypotheses.begin() + index);
                std::vector<int> motions;
                bool matched = true;
                int dart = partner;
                for (int leaving : s.path(s.vertex(partner), 0)) { // lines 9-13
                    motions.push_back(leaving - dart);
                    const Percept sensed = co_yield move_by(motions.back() - std::exchange(turned, 0));
                    dart = s.darts[leaving].twin;
                    if (!alike(s.darts[dart].expected, sensed)) {
                        matched = false;
                        break;
                    }
                }
                if (matched) { // case (3), lines 18-19
                    s.explore(goal, partner);
                    here = dart;
                    confirmed = true;
                    continue;
                }
                int turn = 0; // cases (1) and (2), line 15
                for (; !motions.empty(); motions.pop_back()) {
                    co_yield move_by(turn);
                    turn = -motions.back();
                }
                turned = -turn;
            }
            if (!confirmed) { // lines 20-21
                const int entry = s.add_vertex(seen);
                s.explore(goal, entry);
                here = s.turned(entry, turned);
            }
            co_yield {ALLWORLDS_CHECKPOINT, 0};
        }
    }
};

} // namespace

extern "C" {

int32_t allworlds_version(void) { return ALLWORLDS_VERSION; }

void *allworlds_new(void) { return new Robot; }

void allworlds_delete(void *state) { delete static_cast<Robot *>(state); }

void allworlds_choose(void *state, allworlds_pick pick, void *context)
{
    static_cast<Robot *>(state)->pick = pick;
    static_cast<Robot *>(state)->context = context;
}

void allworlds_start(void *state, const Percept *percept, int32_t, allworlds_action *action)
{
    auto &robot = *static_cast<Robot *>(state);
    robot.s = {};
    robot.here = 0;
    robot.exploration = std::make_unique<Exploration>(robot.explore(*percept));
    *action = robot.exploration->go_on(*percept);
}

void allworlds_step(void *state, const Percept *percept, allworlds_action *action)
{
    *action = static_cast<Robot *>(state)->exploration->go_on(*percept);
}

int32_t allworlds_answer(void *state, int32_t capacity, int32_t *sigma, int32_t *alpha, int32_t *here)
{
    const auto &robot = *static_cast<const Robot *>(state);
    const int darts = static_cast<int>(robot.s.darts.size());
    if (darts > capacity)
        return darts;
    for (int dart = 0; dart < darts; dart++) {
        sigma[dart] = robot.s.turned(dart, 1);
        alpha[dart] = robot.s.darts[dart].twin;
    }
    *here = robot.here;
    return darts;
}
}
