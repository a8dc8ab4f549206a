/* A shared library whose explorer is a generator of Python: FOLDER, EXPLORER.
 *
 * It is loaded by an interpreter, and asks that one to run shimmed.py, which does the rest.
 */
#include <allworlds.h>

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

typedef struct object object;

int PyGILState_Ensure(void);
void PyGILState_Release(int);
int PyRun_SimpleString(const char *);
object *PyImport_ImportModule(const char *);
object *PyObject_CallMethod(object *, const char *, const char *, ...);
long PyLong_AsLong(object *);
void PyErr_Print(void);
void Py_DecRef(object *);

static object *shim;

static long checked(object *result)
{
    if (!result) {
        PyErr_Print();
        abort();
    }
    long value = PyLong_AsLong(result);
    Py_DecRef(result);
    return value;
}

#define CALL(...)                                                      \
    int lock = PyGILState_Ensure();                                    \
    long value = checked(PyObject_CallMethod(shim, __VA_ARGS__));      \
    PyGILState_Release(lock);                                          \
    (void)value;

typedef unsigned long long address;
#define AT(pointer) ((address)(uintptr_t)(pointer))

int32_t allworlds_version(void) { return ALLWORLDS_VERSION; }

void *allworlds_new(void)
{
    int lock = PyGILState_Ensure();
    PyRun_SimpleString("import sys; sys.path.append('" FOLDER "')");
    object *module = PyImport_ImportModule("shimmed");
    if (module)
        shim = PyObject_CallMethod(module, "Shim", "s", EXPLORER);
    if (!shim)
        PyErr_Print();
    PyGILState_Release(lock);
    return shim;
}

void allworlds_delete(void *state) { (void)state; }

void allworlds_start(void *state, const allworlds_percept *percept, int32_t told,
                     allworlds_action *action)
{
    CALL("start", "KiK", AT(percept), told, AT(action))
    (void)state;
}

void allworlds_step(void *state, const allworlds_percept *percept, allworlds_action *action)
{
    CALL("step", "KK", AT(percept), AT(action))
    (void)state;
}

int32_t allworlds_answer(void *state, int32_t capacity, int32_t *sigma, int32_t *alpha, int32_t *here)
{
    CALL("answer", "iKKK", capacity, AT(sigma), AT(alpha), AT(here))
    (void)state;
    return (int32_t)value;
}
