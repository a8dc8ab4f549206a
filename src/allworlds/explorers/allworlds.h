/* allworlds.h, version 2: explorers in C, and in every language that can export C functions.
 *
 * An explorer is a shared library that defines the functions below.  It is tried with
 *
 *     allworlds check --native ./my_explorer.so --edges 5
 *
 * and takes part in run, replay, fuzz and compare in the same way.  One command builds it:
 *
 *     cc -O2 -shared -fPIC -I FOLDER -o my_explorer.so my_explorer.c
 *
 * where FOLDER holds this file: `allworlds init --header > FOLDER/allworlds.h`.
 *
 * HOW AN EPISODE GOES
 *
 *     state = allworlds_new()                          once in a process, or more often
 *     allworlds_choose(state, pick, context)           if the library has it
 *     allworlds_start(state, &percept, told, &action)  an episode begins
 *     allworlds_step(state, &percept, &action)         ... after each action
 *     n = allworlds_answer(state, capacity, sigma, alpha, &here)
 *     allworlds_delete(state)                          at the end; or the process just ends
 *
 * `start` and `step` set `action`: a motion, a drop or a pick of a marker, a checkpoint, or
 * ALLWORLDS_ANSWER.  After a motion `step` gets what is sensed at its end; after a drop or a pick,
 * what is now sensed at the same place; after a checkpoint, the same percept as before.
 * ALLWORLDS_ANSWER ends the episode: `answer` is called once, and then a new episode begins with
 * `start`, in the same state, in any world.  ALLWORLDS_AMBIGUOUS and `quotient` do the same.
 * An episode can also end without an answer (the budget is spent, or the action was not legal):
 * then the next call is `start`, too.  `start` must forget every earlier episode: each world is
 * explored twice, in different processes and in different orders, and both explorations must be
 * the same.
 *
 * WHAT MAY BE ASSUMED
 *
 *  - `state` is what `new` has returned; allworlds only passes it on.  It belongs to the library,
 *    as does all memory that the library has allocated.
 *  - Pointers to percepts, actions and buffers are valid during the call, and belong to the caller.
 *    They are never NULL (`cost` below may be), and do not overlap.
 *  - One state is used by one thread at a time, and by one process only.  There can be several
 *    states in a process.
 *  - Before each call of `start` and `step`, `*action` is all zero, which is no legal action.
 *  - stdin is empty.  `allworlds run` and findings show what the library writes to stdout and
 *    stderr.  In all other runs this output is thrown away.
 *
 * WHAT IS NOT ALLOWED
 *
 *  - to leave a function by longjmp or by an exception
 *  - to leave a thread or a process behind when an episode has ended
 *
 * WHAT BREAKS A LAW
 *
 *  - a signal, abort() or exit(), or a thread that is left behind: `crash`
 *  - a call that takes longer than --answer-timeout seconds: `timeout`
 *  - an action whose `kind` is none of those below, a drop or a pick for which there is no marker,
 *    or ALLWORLDS_AMBIGUOUS without a `quotient`: `illegal-action`
 *  - an answer that is no map, or `here` that is no dart of it, or more darts than there is room
 *    for: `no-estimate`
 *  - another walk or answer when the same percepts are met again: `nondeterministic`
 *
 * Your code runs in processes of its own.  If it crashes or hangs there, that is a finding in the
 * world that it was in, and the check goes on.  Such a process has 2 GB of address space for its
 * library, or what --memory says.
 *
 * WHAT STAYS
 *
 * A library that is built with version 2 is accepted by every later release whose header says
 * version 2, and behaves in the same way.  New kinds of actions may come, which no library need
 * use; existing names, numbers, structures and functions do not change.  If one of these has to
 * change, the version becomes 3; a library of version 2 then still works as before, or is refused
 * with an error message of one line.
 */
#ifndef ALLWORLDS_H
#define ALLWORLDS_H

#include <stdint.h>

#define ALLWORLDS_VERSION 2

#if defined(__GNUC__) || defined(__clang__)
#define ALLWORLDS_EXPORT __attribute__((visibility("default")))
#else
#define ALLWORLDS_EXPORT
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* What is sensed at a vertex.  12 bytes. */
typedef struct allworlds_percept {
    int32_t degree;  /* of the vertex, at least 1 */
    int32_t marks;   /* markers that can be seen here; at v0 of the directional lighthouse 1 */
    int32_t bearing; /* clockwise from the dart arrived by to the pointed dart, below the degree;
                        -1 where no direction is sensed */
} allworlds_percept;

/* What the robot does.  8 bytes. */
typedef struct allworlds_action {
    int32_t kind;    /* one of the following */
    int32_t motion;  /* of a move: leave by the dart that is `motion` places clockwise of the dart
                        arrived by (at the start: of the dart faced); any integer, modulo the
                        degree.  0 goes back.  Other actions ignore it. */
} allworlds_action;

enum {
    ALLWORLDS_MOVE = 1,       /* one edge */
    ALLWORLDS_DROP = 2,       /* lay down a marker, where the lighthouse gives markers */
    ALLWORLDS_PICK = 3,       /* pick one up */
    ALLWORLDS_CHECKPOINT = 4, /* show the judge what is known: `answer` is called, then `step` */
    ALLWORLDS_ANSWER = 5,     /* the map is known: `answer` is called, and the episode ends */
    ALLWORLDS_AMBIGUOUS = 6   /* for the lighthouse `position`: several maps look like this one;
                                 `quotient` is called, and the episode ends */
};

/* What a choice is about. */
enum {
    ALLWORLDS_EDGE = 0,       /* the dart that is explored next */
    ALLWORLDS_HYPOTHESIS = 1, /* the hypothesis that is tested next */
    ALLWORLDS_PATH = 2,       /* the next dart of a path that tests a hypothesis */
    ALLWORLDS_TRANSIT = 3     /* the next dart on the way to the dart that is explored */
};

/* The value of `told` in `allworlds_start` if the lighthouse tells nothing. */
#define ALLWORLDS_NOTHING (-1)

/* Asks for a choice: returns the index of the option to take, from 0 to options - 1.
 *
 * context  the one that `choose` was given
 * of       what the choice is about: one of the numbers above
 * options  how many there are, at least 1, in the order in which they came to be known
 * cost     the walking distance of each, or NULL
 *
 * Call this function from within `start` and `step` only.
 */
typedef int32_t (*allworlds_pick)(void *context, int32_t of, int32_t options, const int32_t *cost);

/* ALLWORLDS_VERSION, as it was when the library was built. */
ALLWORLDS_EXPORT int32_t allworlds_version(void);

/* A state in which `start` can be called; NULL (a crash) if there is none. */
ALLWORLDS_EXPORT void *allworlds_new(void);

/* The end of a state. */
ALLWORLDS_EXPORT void allworlds_delete(void *state);

/* A new episode: what is sensed before any motion, what the lighthouse tells (`natural`: the degree
 * of v1) or ALLWORLDS_NOTHING, and room for the first action. */
ALLWORLDS_EXPORT void allworlds_start(void *state, const allworlds_percept *percept, int32_t told,
                                      allworlds_action *action);

/* What is sensed after the last action, and room for the next one. */
ALLWORLDS_EXPORT void allworlds_step(void *state, const allworlds_percept *percept,
                                     allworlds_action *action);

/* Writes sigma and alpha of each dart of the map, and returns the number of darts.
 *
 * Darts are 0, 1, 2, ...; sigma leads to the next dart clockwise round a vertex, alpha to the other
 * dart of the edge.  In a checkpoint alpha[d] == d says that it is not known yet where d leads.
 * *here is the map's dart for the dart by which the robot arrived last (before any motion: for the
 * dart that it faces).
 *
 * `capacity` is at least 262144, and at least the sum of all degrees sensed in this episode.  If
 * the map has more than `capacity` darts, return their number, and write nothing: this breaks a
 * law, `no-estimate` or, in a checkpoint, `illegal-action`.
 */
ALLWORLDS_EXPORT int32_t allworlds_answer(void *state, int32_t capacity, int32_t *sigma,
                                          int32_t *alpha, int32_t *here);

/* Optional: gets the function that answers the choices of the next episode; called before each
 * `start`.
 *
 * If the library has this function, --policy decides the choices, and --schedules all tries every
 * sequence of them.
 */
ALLWORLDS_EXPORT void allworlds_choose(void *state, allworlds_pick pick, void *context);

/* Optional: the rooted quotient, all that can be known where several worlds look alike.
 *
 * As `answer`, and for each dart of it what is sensed there.  alpha[d] == d is a semi-edge: a dart
 * that no motion tells apart from the other one of its edge.
 */
ALLWORLDS_EXPORT int32_t allworlds_quotient(void *state, int32_t capacity, int32_t *sigma,
                                            int32_t *alpha, int32_t *degree, int32_t *marks,
                                            int32_t *here);

#ifdef __cplusplus
}
#endif

#endif
