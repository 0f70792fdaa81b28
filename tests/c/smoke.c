/* The FMU's library as a simulator written in C uses it, for tests/test_c.py:
 *
 *     smoke fmi2|fmi3 LIBRARY TOKEN RESOURCES THETA_1 R
 *
 * RESOURCES is a URI for FMI 2 and a path for FMI 3; THETA_1 and R are value
 * references. Prints the reach at 60 deg, in m. Any surprise ends it with 1.
 * The declarations are written after the text of the standards. */

#include <dlfcn.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { OK, WARNING, DISCARD, ERROR };
enum { MODEL_EXCHANGE, CO_SIMULATION };
enum { MANY = 100 };

static const double LOWEST = 1.0471975511965976;   /* 60 deg */
static const double FURTHER = 1.2;                 /* within the working range */
static const double OUT_OF_REACH = 0.785398163397; /* 45 deg: the linkage closes from 48.96 deg */

/* What the FMU is given as its environment, and must give back to the logger. */
struct environment {
    int messages;
};

#define FAIL(...)                                                  \
    do {                                                           \
        fprintf(stderr, "%s:%d: ", __FILE__, __LINE__);            \
        fprintf(stderr, __VA_ARGS__);                              \
        fprintf(stderr, "\n");                                     \
        exit(1);                                                   \
    } while (0)
#define EXPECT(condition)                          \
    do {                                           \
        if (!(condition)) FAIL("%s", #condition);  \
    } while (0)
#define IS_OK(call)                                        \
    do {                                                   \
        int status = (call);                               \
        if (status != OK) FAIL("%s: %d", #call, status);   \
    } while (0)
/* Refused with a status of the standard's and one message. */
#define IS_REFUSED(call)                                             \
    do {                                                             \
        int before = environment.messages;                           \
        int status = (call);                                         \
        if (status != DISCARD && status != ERROR)                    \
            FAIL("%s: %d", #call, status);                           \
        if (environment.messages != before + 1)                      \
            FAIL("%s: %d messages", #call, environment.messages - before); \
    } while (0)

static void *symbol(void *library, const char *name)
{
    void *found = dlsym(library, name);
    if (found == NULL) FAIL("%s is not exported", name);
    return found;
}
/* Declares a function of the standard under its own name and finds it. */
#define LOAD(result, name, ...)    \
    result (*name)(__VA_ARGS__);   \
    *(void **)&name = symbol(library, #name)

static void count(struct environment *environment, const char *category, const char *message)
{
    EXPECT(environment != NULL && category != NULL && message != NULL && message[0] != '\0');
    EXPECT(strncmp(category, "logStatus", 9) == 0);
    environment->messages += 1;
}

static void log_message2(void *environment, const char *name, int status, const char *category, const char *format, ...)
{
    char message[1000];
    va_list arguments;
    EXPECT(name != NULL && status != OK);
    va_start(arguments, format);
    EXPECT(vsnprintf(message, sizeof message, format, arguments) > 0);
    va_end(arguments);
    count(environment, category, message);
}

static void log_message3(void *environment, int status, const char *category, const char *message)
{
    EXPECT(status != OK);
    count(environment, category, message);
}

struct callbacks2 {
    void (*logger)(void *, const char *, int, const char *, const char *, ...);
    void *(*allocate)(size_t, size_t);
    void (*release)(void *);
    void (*step_finished)(void *, int);
    void *environment;
};

struct event_info2 {
    int new_discrete_states_needed, terminate, nominals_changed, values_changed, next_event_defined;
    double next_event;
};

static double fmi2(void *library, const char *token, const char *resources, unsigned theta_1, unsigned reach)
{
    LOAD(const char *, fmi2GetVersion, void);
    LOAD(void *, fmi2Instantiate, const char *, int, const char *, const char *, const struct callbacks2 *, int, int);
    LOAD(void, fmi2FreeInstance, void *);
    LOAD(int, fmi2SetupExperiment, void *, int, double, double, int, double);
    LOAD(int, fmi2EnterInitializationMode, void *);
    LOAD(int, fmi2ExitInitializationMode, void *);
    LOAD(int, fmi2Reset, void *);
    LOAD(int, fmi2Terminate, void *);
    LOAD(int, fmi2SetReal, void *, const unsigned *, size_t, const double *);
    LOAD(int, fmi2GetReal, void *, const unsigned *, size_t, double *);
    LOAD(int, fmi2DoStep, void *, double, double, int);
    LOAD(int, fmi2GetFMUstate, void *, void **);
    LOAD(int, fmi2SetFMUstate, void *, void *);
    LOAD(int, fmi2FreeFMUstate, void *, void **);
    LOAD(int, fmi2SerializedFMUstateSize, void *, void *, size_t *);
    LOAD(int, fmi2SerializeFMUstate, void *, void *, char *, size_t);
    LOAD(int, fmi2DeSerializeFMUstate, void *, const char *, size_t, void **);
    LOAD(int, fmi2GetDirectionalDerivative, void *, const unsigned *, size_t, const unsigned *, size_t, const double *,
         double *);
    LOAD(int, fmi2NewDiscreteStates, void *, struct event_info2 *);
    LOAD(int, fmi2EnterContinuousTimeMode, void *);
    LOAD(int, fmi2SetTime, void *, double);
    LOAD(int, fmi2CompletedIntegratorStep, void *, int, int *, int *);

    struct environment environment = {0};
    const struct callbacks2 callbacks = {log_message2, calloc, free, NULL, &environment};
    EXPECT(strcmp(fmi2GetVersion(), "2.0") == 0);

    EXPECT(fmi2Instantiate("100 %s", CO_SIMULATION, "{other}", resources, &callbacks, 0, 0) == NULL);
    EXPECT(environment.messages == 1);

    void *many[MANY];
    for (int i = 0; i < MANY; i++) {
        many[i] = fmi2Instantiate("one of many", CO_SIMULATION, token, resources, &callbacks, 0, 0);
        EXPECT(many[i] != NULL);
        IS_OK(fmi2EnterInitializationMode(many[i]));
    }
    for (int i = 0; i < MANY; i++) fmi2FreeInstance(many[i]);
    fmi2FreeInstance(NULL);

    /* Co-Simulation */
    void *crane = fmi2Instantiate("crane", CO_SIMULATION, token, resources, &callbacks, 0, 0);
    EXPECT(crane != NULL);
    IS_OK(fmi2SetupExperiment(crane, 0, 0.0, 0.0, 0, 0.0));
    IS_OK(fmi2EnterInitializationMode(crane));
    IS_OK(fmi2ExitInitializationMode(crane));
    double value, again;
    IS_OK(fmi2SetReal(crane, &theta_1, 1, &FURTHER));
    IS_OK(fmi2DoStep(crane, 0.0, 1.0, 1));
    IS_OK(fmi2GetReal(crane, &reach, 1, &value));
    const double one = 1.0;
    double slope;
    IS_OK(fmi2GetDirectionalDerivative(crane, &reach, 1, &theta_1, 1, &one, &slope));
    EXPECT(slope < 0.0); /* raising the boom brings the load in */

    void *state = NULL, *copy = NULL;
    size_t size;
    IS_OK(fmi2GetFMUstate(crane, &state));
    IS_OK(fmi2SerializedFMUstateSize(crane, state, &size));
    char *bytes = malloc(size);
    EXPECT(bytes != NULL);
    IS_OK(fmi2SerializeFMUstate(crane, state, bytes, size));
    IS_OK(fmi2DeSerializeFMUstate(crane, bytes, size, &copy));
    bytes[size - 1] ^= 1;
    void *damaged = NULL;
    IS_REFUSED(fmi2DeSerializeFMUstate(crane, bytes, size, &damaged));
    free(bytes);
    IS_OK(fmi2SetReal(crane, &theta_1, 1, &LOWEST));
    IS_OK(fmi2DoStep(crane, 1.0, 1.0, 1));
    IS_OK(fmi2SetFMUstate(crane, copy));
    IS_OK(fmi2GetReal(crane, &reach, 1, &again));
    EXPECT(value == again);
    IS_OK(fmi2FreeFMUstate(crane, &state));
    IS_OK(fmi2FreeFMUstate(crane, &copy));

    /* What is refused leaves the instance whole. */
    const unsigned unknown = 123456;
    IS_REFUSED(fmi2GetReal(crane, &unknown, 1, &again));
    IS_REFUSED(fmi2GetReal(crane, NULL, 1, &again));
    IS_REFUSED(fmi2SetTime(crane, 1.0));
    IS_OK(fmi2SetReal(crane, &theta_1, 1, &OUT_OF_REACH));
    IS_REFUSED(fmi2DoStep(crane, 1.0, 1.0, 1));
    IS_OK(fmi2Reset(crane));
    IS_OK(fmi2EnterInitializationMode(crane));
    IS_OK(fmi2ExitInitializationMode(crane));
    IS_OK(fmi2SetReal(crane, &theta_1, 1, &LOWEST));
    IS_OK(fmi2DoStep(crane, 0.0, 1.0, 1));
    IS_OK(fmi2GetReal(crane, &reach, 1, &value));
    IS_OK(fmi2Terminate(crane));
    fmi2FreeInstance(crane);

    /* Model Exchange, without a logger */
    struct event_info2 info;
    int enter_event_mode, terminate;
    crane = fmi2Instantiate("crane", MODEL_EXCHANGE, token, resources, NULL, 0, 1);
    EXPECT(crane != NULL);
    IS_OK(fmi2EnterInitializationMode(crane));
    IS_OK(fmi2ExitInitializationMode(crane));
    IS_OK(fmi2NewDiscreteStates(crane, &info));
    EXPECT(!info.new_discrete_states_needed && !info.terminate);
    IS_OK(fmi2EnterContinuousTimeMode(crane));
    EXPECT(fmi2GetReal(crane, &unknown, 1, &again) == ERROR);
    IS_OK(fmi2SetTime(crane, 1.0));
    IS_OK(fmi2SetReal(crane, &theta_1, 1, &LOWEST));
    IS_OK(fmi2GetReal(crane, &reach, 1, &again));
    EXPECT(value == again);
    IS_OK(fmi2CompletedIntegratorStep(crane, 1, &enter_event_mode, &terminate));
    EXPECT(!terminate);
    /* Freed without having been terminated. */
    fmi2FreeInstance(crane);
    return value;
}

static double fmi3(void *library, const char *token, const char *resources, uint32_t theta_1, uint32_t reach)
{
    typedef void (*log3)(void *, int, const char *, const char *);
    LOAD(const char *, fmi3GetVersion, void);
    LOAD(void *, fmi3InstantiateCoSimulation, const char *, const char *, const char *, bool, bool, bool, bool,
         const uint32_t *, size_t, void *, log3, void *);
    LOAD(void *, fmi3InstantiateModelExchange, const char *, const char *, const char *, bool, bool, void *, log3);
    LOAD(void, fmi3FreeInstance, void *);
    LOAD(int, fmi3EnterInitializationMode, void *, bool, double, double, bool, double);
    LOAD(int, fmi3ExitInitializationMode, void *);
    LOAD(int, fmi3Reset, void *);
    LOAD(int, fmi3Terminate, void *);
    LOAD(int, fmi3SetFloat64, void *, const uint32_t *, size_t, const double *, size_t);
    LOAD(int, fmi3GetFloat64, void *, const uint32_t *, size_t, double *, size_t);
    LOAD(int, fmi3DoStep, void *, double, double, bool, bool *, bool *, bool *, double *);
    LOAD(int, fmi3GetFMUState, void *, void **);
    LOAD(int, fmi3SetFMUState, void *, void *);
    LOAD(int, fmi3FreeFMUState, void *, void **);
    LOAD(int, fmi3SerializedFMUStateSize, void *, void *, size_t *);
    LOAD(int, fmi3SerializeFMUState, void *, void *, uint8_t *, size_t);
    LOAD(int, fmi3DeserializeFMUState, void *, const uint8_t *, size_t, void **);
    LOAD(int, fmi3GetDirectionalDerivative, void *, const uint32_t *, size_t, const uint32_t *, size_t, const double *,
         size_t, double *, size_t);
    LOAD(int, fmi3GetAdjointDerivative, void *, const uint32_t *, size_t, const uint32_t *, size_t, const double *, size_t,
         double *, size_t);
    LOAD(int, fmi3UpdateDiscreteStates, void *, bool *, bool *, bool *, bool *, bool *, double *);
    LOAD(int, fmi3EnterContinuousTimeMode, void *);
    LOAD(int, fmi3SetTime, void *, double);
    LOAD(int, fmi3CompletedIntegratorStep, void *, bool, bool *, bool *);

    struct environment environment = {0};
    EXPECT(strncmp(fmi3GetVersion(), "3.0", 3) == 0);

    EXPECT(fmi3InstantiateCoSimulation("100 %s", "{other}", resources, false, false, false, false, NULL, 0, &environment,
                                       log_message3, NULL) == NULL);
    EXPECT(environment.messages == 1);

    void *many[MANY];
    for (int i = 0; i < MANY; i++) {
        many[i] = fmi3InstantiateCoSimulation("one of many", token, resources, false, false, false, false, NULL, 0,
                                              &environment, log_message3, NULL);
        EXPECT(many[i] != NULL);
        IS_OK(fmi3EnterInitializationMode(many[i], false, 0.0, 0.0, false, 0.0));
    }
    for (int i = 0; i < MANY; i++) fmi3FreeInstance(many[i]);
    fmi3FreeInstance(NULL);

    /* Co-Simulation */
    void *crane = fmi3InstantiateCoSimulation("crane", token, resources, false, false, false, false, NULL, 0,
                                              &environment, log_message3, NULL);
    EXPECT(crane != NULL);
    IS_OK(fmi3EnterInitializationMode(crane, false, 0.0, 0.0, false, 0.0));
    IS_OK(fmi3ExitInitializationMode(crane));
    double value, again, time;
    bool event, terminate, early;
    IS_OK(fmi3SetFloat64(crane, &theta_1, 1, &FURTHER, 1));
    IS_OK(fmi3DoStep(crane, 0.0, 1.0, true, &event, &terminate, &early, &time));
    EXPECT(!event && !terminate && !early && time == 1.0);
    IS_OK(fmi3GetFloat64(crane, &reach, 1, &value, 1));
    const double one = 1.0;
    double slope, adjoint;
    IS_OK(fmi3GetDirectionalDerivative(crane, &reach, 1, &theta_1, 1, &one, 1, &slope, 1));
    IS_OK(fmi3GetAdjointDerivative(crane, &reach, 1, &theta_1, 1, &one, 1, &adjoint, 1));
    EXPECT(slope < 0.0 && slope == adjoint); /* raising the boom brings the load in */

    void *state = NULL, *copy = NULL;
    size_t size;
    IS_OK(fmi3GetFMUState(crane, &state));
    IS_OK(fmi3SerializedFMUStateSize(crane, state, &size));
    uint8_t *bytes = malloc(size);
    EXPECT(bytes != NULL);
    IS_OK(fmi3SerializeFMUState(crane, state, bytes, size));
    IS_OK(fmi3DeserializeFMUState(crane, bytes, size, &copy));
    bytes[size - 1] ^= 1;
    void *damaged = NULL;
    IS_REFUSED(fmi3DeserializeFMUState(crane, bytes, size, &damaged));
    free(bytes);
    IS_OK(fmi3SetFloat64(crane, &theta_1, 1, &LOWEST, 1));
    IS_OK(fmi3DoStep(crane, 1.0, 1.0, true, &event, &terminate, &early, &time));
    IS_OK(fmi3SetFMUState(crane, copy));
    IS_OK(fmi3GetFloat64(crane, &reach, 1, &again, 1));
    EXPECT(value == again);
    IS_OK(fmi3FreeFMUState(crane, &state));
    IS_OK(fmi3FreeFMUState(crane, &copy));

    /* What is refused leaves the instance whole. */
    const uint32_t unknown = 123456;
    IS_REFUSED(fmi3GetFloat64(crane, &unknown, 1, &again, 1));
    IS_REFUSED(fmi3GetFloat64(crane, NULL, 1, &again, 1));
    IS_REFUSED(fmi3SetTime(crane, 1.0));
    IS_OK(fmi3SetFloat64(crane, &theta_1, 1, &OUT_OF_REACH, 1));
    IS_REFUSED(fmi3DoStep(crane, 1.0, 1.0, true, &event, &terminate, &early, &time));
    EXPECT(time == 1.0);
    IS_OK(fmi3Reset(crane));
    IS_OK(fmi3EnterInitializationMode(crane, false, 0.0, 0.0, false, 0.0));
    IS_OK(fmi3ExitInitializationMode(crane));
    IS_OK(fmi3SetFloat64(crane, &theta_1, 1, &LOWEST, 1));
    IS_OK(fmi3DoStep(crane, 0.0, 1.0, true, &event, &terminate, &early, &time));
    IS_OK(fmi3GetFloat64(crane, &reach, 1, &value, 1));
    IS_OK(fmi3Terminate(crane));
    fmi3FreeInstance(crane);

    /* Model Exchange, without a logger */
    bool needs_update, nominals, values, next_defined, enter_event_mode;
    double next;
    crane = fmi3InstantiateModelExchange("crane", token, resources, false, true, NULL, NULL);
    EXPECT(crane != NULL);
    IS_OK(fmi3EnterInitializationMode(crane, false, 0.0, 0.0, false, 0.0));
    IS_OK(fmi3ExitInitializationMode(crane));
    IS_OK(fmi3UpdateDiscreteStates(crane, &needs_update, &terminate, &nominals, &values, &next_defined, &next));
    EXPECT(!needs_update && !terminate);
    IS_OK(fmi3EnterContinuousTimeMode(crane));
    EXPECT(fmi3GetFloat64(crane, &unknown, 1, &again, 1) == ERROR);
    IS_OK(fmi3SetTime(crane, 1.0));
    IS_OK(fmi3SetFloat64(crane, &theta_1, 1, &LOWEST, 1));
    IS_OK(fmi3GetFloat64(crane, &reach, 1, &again, 1));
    EXPECT(value == again);
    IS_OK(fmi3CompletedIntegratorStep(crane, true, &enter_event_mode, &terminate));
    EXPECT(!terminate);
    /* Freed without having been terminated. */
    fmi3FreeInstance(crane);
    return value;
}

int main(int count, char **arguments)
{
    if (count != 7) FAIL("usage: smoke fmi2|fmi3 LIBRARY TOKEN RESOURCES THETA_1 R");
    void *library = dlopen(arguments[2], RTLD_NOW | RTLD_LOCAL);
    if (library == NULL) FAIL("%s", dlerror());
    bool is_fmi2 = strcmp(arguments[1], "fmi2") == 0;
    uint32_t theta_1 = (uint32_t)strtoul(arguments[5], NULL, 10), reach = (uint32_t)strtoul(arguments[6], NULL, 10);
    double value = (is_fmi2 ? fmi2 : fmi3)(library, arguments[3], arguments[4], theta_1, reach);
    EXPECT(dlclose(library) == 0);
    printf("%.17g\n", value);
    return 0;
}
