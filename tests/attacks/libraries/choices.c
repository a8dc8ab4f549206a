/* Explorers whose choices, or what they do after them, tell one play from another.
 *
 * verdict of by_turns: refuted nondeterministic
 * verdict of once: refuted nondeterministic
 * verdict of twice: refuted nondeterministic
 * options: --edges 2 --schedules all
 */
#define allworlds_choose right_choose
#include "right.h"
#undef allworlds_choose

static allworlds_pick ask;
static void *context;
static int32_t episodes, wrong;

/* Another number of options in each episode. */
static inline int32_t by_turns(void)
{
    ask(context, ALLWORLDS_EDGE, 1 + episodes % 3, NULL);
    return 0;
}

/* A choice in the first episodes, and none later. */
static inline int32_t once(void)
{
    if (episodes < 4)
        ask(context, ALLWORLDS_EDGE, 2, NULL);
    return 0;
}

/* Wrong if the last option is taken twice in succession: never while all schedules are tried in order. */
static inline int32_t twice(void)
{
    static int32_t before;
    int32_t now = ask(context, ALLWORLDS_EDGE, 2, NULL), both = now && before;
    before = now;
    return both;
}

void allworlds_choose(void *state, allworlds_pick given, void *with)
{
    (void)state;
    ask = given, context = with;
}

void allworlds_start(void *state, const allworlds_percept *percept, int32_t told,
                     allworlds_action *action)
{
    wrong = ATTACK();
    episodes++;
    right_start(state, percept, told, action);
}

void allworlds_step(void *state, const allworlds_percept *percept, allworlds_action *action)
{
    right_step(state, percept, action);
}

int32_t allworlds_answer(void *state, int32_t capacity, int32_t *sigma, int32_t *alpha,
                         int32_t *here)
{
    return wrong ? 0 : right_answer(state, capacity, sigma, alpha, here);
}
