/* A robot that is right in both worlds with one edge, but where v0 has degree 1 it ATTACKs.
 *
 * Built with -DATTACK='...', which may use all that is declared here.
 */
#include <allworlds.h>

#include <pthread.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static int32_t kind, count, here_is, degree, episodes, steps;
char state[16];
void *thrown[1 << 16];

#ifndef VERSION
#define VERSION ALLWORLDS_VERSION
#endif
#ifndef NEW
#define NEW state
#endif
#ifndef ATTACK
#define ATTACK
#endif

/* How many steps it makes, to and fro: an odd number. */
#ifndef STEPS
#define STEPS 1
#endif

#ifdef CHOOSES
static allworlds_pick pick;
static void *asked;
void allworlds_choose(void *none, allworlds_pick given, void *context)
{
    (void)none;
    pick = given, asked = context;
}
#endif

static char *far_away(void) { return (char *)thrown + ((long)getpid() << 33); }

static void *wait_for_ever(void *none) { for (;;) pause(); return none; }
static void *do_nothing(void *none) { return none; }

void in_another_thread(void *(*run)(void *), int join)
{
    pthread_t thread;
    pthread_create(&thread, NULL, run, NULL);
    if (join)
        pthread_join(thread, NULL);
}

void grow(void)
{
    for (long i = 0;; i++) {
        char *more = malloc(1 << 20);
        *more = 1;
        thrown[i % (1 << 16)] = more;
    }
}

int32_t allworlds_version(void) { return VERSION; }
void *allworlds_new(void) { return NEW; }
void allworlds_delete(void *none) { (void)none; }

void allworlds_start(void *none, const allworlds_percept *percept, int32_t told,
                     allworlds_action *action)
{
    (void)none, (void)told, (void)wait_for_ever, (void)do_nothing, (void)far_away;
    kind = ALLWORLDS_MOVE, count = 2, here_is = 1, steps = 1;
    degree = percept->degree;
    action->motion = 0;
    if (degree == 1) {
        ATTACK;
    }
    episodes++;
    action->kind = kind;
}

void allworlds_step(void *none, const allworlds_percept *percept, allworlds_action *action)
{
    (void)none, (void)percept;
    action->kind = steps++ < STEPS ? ALLWORLDS_MOVE : ALLWORLDS_ANSWER;
}

int32_t allworlds_answer(void *none, int32_t capacity, int32_t *sigma, int32_t *alpha, int32_t *here)
{
    (void)none;
    for (int32_t d = 0; d < count && d < capacity; d++)
        sigma[d] = degree == 1 ? d : (d + 1) % count, alpha[d] = d ^ 1;
    *here = here_is;
    return count;
}
