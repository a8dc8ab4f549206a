/* A right explorer, whose functions are called right_start, right_step and right_answer. */
#include <allworlds.h>

#define allworlds_start right_start
#define allworlds_step right_step
#define allworlds_answer right_answer
#include "algorithm1.c"
#undef allworlds_start
#undef allworlds_step
#undef allworlds_answer
