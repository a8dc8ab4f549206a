/* Right explorers, each of which does one thing besides in every episode.
 *
 * verdict of above_the_percept: refuted crash
 * verdict of far_below_the_percept: refuted crash
 * verdict of just_below_the_percept: holds
 * verdict of counts_in_a_global: refuted nondeterministic or no-estimate
 * verdict of leaves_a_thread: refuted crash
 * verdict of jumps: holds
 * verdict of raises_a_signal: refuted crash
 * verdict of catches_its_signal: holds
 * verdict of forks_once: holds
 * verdict of closes_all: refuted crash
 * verdict of takes_all_memory: refuted crash
 * verdict of leaves: refuted crash
 * verdict of constructor_loops: refused
 * verdict of constructor_leaves: refused
 * options: --edges 2 --answer-timeout 4 --start-timeout 8
 */
#define _GNU_SOURCE
#include "right.h"

#include <pthread.h>
#include <setjmp.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define WAY(name) static inline void name(int32_t *percept)

static int spoilt;

WAY(above_the_percept) { ((volatile int32_t *)percept)[3] = 1; }

WAY(far_below_the_percept) { *((volatile char *)percept - (1L << 44)) = 1; }

WAY(just_below_the_percept) { ((volatile int32_t *)percept)[-1] = 1; }

WAY(counts_in_a_global)
{
    static int episodes;
    (void)percept;
    spoilt = ++episodes % 3 == 0;
}

static void *sleeping(void *nothing)
{
    for (;;)
        pause();
    return nothing;
}

WAY(leaves_a_thread)
{
    pthread_t thread;
    (void)percept;
    pthread_create(&thread, NULL, sleeping, NULL);
}

WAY(jumps)
{
    jmp_buf here;
    (void)percept;
    if (!setjmp(here))
        longjmp(here, 1);
}

WAY(raises_a_signal)
{
    (void)percept;
    raise(SIGSEGV);
}

static void caught(int number) { (void)number; }

WAY(catches_its_signal)
{
    (void)percept;
    signal(SIGUSR1, caught);
    raise(SIGUSR1);
}

WAY(forks_once)
{
    static int forked;
    (void)percept;
    if (!forked++)
        fork();
}

WAY(closes_all)
{
    (void)percept;
    for (int descriptor = 0; descriptor < 256; descriptor++)
        close(descriptor);
}

WAY(takes_all_memory)
{
    char *block;
    (void)percept;
    while ((block = malloc(1 << 20)))
        *(volatile char *)block = 1;
    abort();
}

WAY(leaves)
{
    (void)percept;
    _exit(0);
}

WAY(constructor_loops) { (void)percept; }

WAY(constructor_leaves) { (void)percept; }

__attribute__((constructor)) static void loaded(void)
{
    void (*attack)(int32_t *) = ATTACK;
    while (attack == constructor_loops)
        pause();
    if (attack == constructor_leaves)
        _exit(0);
}

void allworlds_start(void *state, const allworlds_percept *percept, int32_t told,
                     allworlds_action *action)
{
    right_start(state, percept, told, action);
    ATTACK((int32_t *)percept);
}

void allworlds_step(void *state, const allworlds_percept *percept, allworlds_action *action)
{
    right_step(state, percept, action);
}

int32_t allworlds_answer(void *state, int32_t capacity, int32_t *sigma, int32_t *alpha,
                         int32_t *here)
{
    return spoilt ? 0 : right_answer(state, capacity, sigma, alpha, here);
}
