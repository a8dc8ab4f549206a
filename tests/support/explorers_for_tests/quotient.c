/* Whatever is sensed first, it is the percept of the only dart of a quotient.
 *
 * SIZE darts are said to be there.
 */
#include <allworlds.h>

#ifndef SIZE
#define SIZE 1
#endif

static allworlds_percept first;

int32_t allworlds_version(void) { return ALLWORLDS_VERSION; }
void *allworlds_new(void) { return &first; }
void allworlds_delete(void *state) { (void)state; }

void allworlds_start(void *state, const allworlds_percept *percept, int32_t told,
                     allworlds_action *action)
{
    (void)state, (void)told;
    first = *percept;
    action->kind = ALLWORLDS_AMBIGUOUS;
}

void allworlds_step(void *state, const allworlds_percept *percept, allworlds_action *action)
{
    (void)state, (void)percept, (void)action;
}

int32_t allworlds_answer(void *state, int32_t capacity, int32_t *sigma, int32_t *alpha,
                         int32_t *here)
{
    (void)state, (void)capacity, (void)sigma, (void)alpha, (void)here;
    return 0;
}

int32_t allworlds_quotient(void *state, int32_t capacity, int32_t *sigma, int32_t *alpha,
                           int32_t *degree, int32_t *marks, int32_t *here)
{
    (void)state, (void)capacity;
    sigma[0] = alpha[0] = *here = 0;
    degree[0] = first.degree;
    marks[0] = first.marks;
    return SIZE;
}
