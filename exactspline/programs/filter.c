/* The certified filter for one curve: a straight-line program on every segment in doubles with error masses, then the
   zeros of its outputs. The program is data (see accelerator.py); no formula stands here. What is not certain is said to
   be open and decided in exact arithmetic. Derivation: docs/certified-filter.md. */

#include <float.h>
#include <math.h>
#include <string.h>

#if FLT_EVAL_METHOD != 0 || FLT_RADIX != 2 || DBL_MANT_DIG != 53 || DBL_MIN_EXP != -1021 || defined(__FAST_MATH__)
#error "operations on doubles must round to doubles"
#endif
#ifdef __clang__
#pragma STDC FP_CONTRACT OFF
#endif

/* The most coefficients of a form (with more, binomial coefficients are not exact), numbers in the results of a program,
   and results. */
enum { MOST = 51, ROOM = 4096, RESULTS = 256 };
enum { LOAD, MUL, SUM, RAISE, DERIVE, DU, DV, OVER_U, SCALE };
/* The depths of subdivision, for isolation and to prove that there is no zero; the steps of Newton's method. */
enum { DEPTH = 9, DEEP = 22, STEPS = 40 };

/* As in exactspline/polynomials/doubles.py, which proves the bounds. */
static const double ROUNDING = 0x1p-52, UNDERFLOW = 0x1p-1022, SPLIT = 15.0 / 32, REACHED = 0x1p-48;
static const double WIDTHS[] = {0x1p-46, 0x1p-42, 0x1p-37, 0x1p-30, 0x1p-20, 0x1p-10};

typedef struct {
    int degree;
    double value[MOST], error[MOST];
} Form;

typedef struct {
    double low, high;
    int before;
} Zero;

/* One instruction: its name, its arguments (-1: the number 1), its integers, and the degree of its result. */
typedef struct {
    int name, a, b, degree;
    double m, n;
} Instruction;

/* ---- a program */

static void convolved(double *to, const double *a, int p, const double *b, int q) {
    memset(to, 0, (size_t)(p + q + 1) * sizeof(double));
    for (int i = 0; i <= p; i++)
        for (int j = 0; j <= q; j++)
            to[i + j] += a[i] * b[j];
}

/* The coefficients of (u + v)^n: all are exact for n < MOST, and so are the products on the way. */
static void binomials(double *to, int n) {
    to[0] = 1;
    for (int k = 1; k <= n; k++)
        to[k] = to[k - 1] * (n - k + 1) / k;
}

/* An instruction on values, or on masses, where every difference is a sum and every integer is positive. */
static void carried_out(const Instruction *one, double *to, const double *a, int n, const double *b, int of_b, int mass) {
    double m = mass ? fabs(one->m) : one->m, k = mass ? fabs(one->n) : one->n, power[MOST];
    switch (one->name) {
    case MUL:
        convolved(to, a, n, b, of_b);
        break;
    case SUM:
        for (int i = 0; i <= n; i++)
            to[i] = m * a[i] + k * b[i];
        break;
    case RAISE:
        binomials(power, (int)one->m);
        convolved(to, a, n, power, (int)one->m);
        break;
    case DERIVE:
        for (int i = 0; i < n; i++)
            to[i] = mass ? (i + 1) * a[i + 1] + (n - i) * a[i] : (i + 1) * a[i + 1] - (n - i) * a[i];
        break;
    case DU:
        for (int i = 0; i < n; i++)
            to[i] = (n - i) * a[i];
        break;
    case DV:
        for (int i = 0; i < n; i++)
            to[i] = (i + 1) * a[i + 1];
        break;
    case OVER_U:
        memcpy(to, a, (size_t)n * sizeof(double));
        break;
    default:
        for (int i = 0; i <= n; i++)
            to[i] = m * a[i];
    }
}

/* The Bézier ordinates of a result, with bounds: `factor` masses, and what underflow lost. */
static void ordinates(Form *form, int degree, const double *value, const double *mass, double factor, double lost) {
    double scale[MOST];
    binomials(scale, degree);
    form->degree = degree;
    for (int i = 0; i <= degree; i++) {
        double x = value[i] / scale[i], error = mass[i] * factor + lost;
        form->value[i] = x;
        form->error[i] = error / scale[i] * (1 + 8 * ROUNDING) + 2 * ROUNDING * fabs(x) + UNDERFLOW;
    }
}

/* ---- zeros */

static int sign_of(const Form *form, int i) {
    double x = form->value[i], e = form->error[i];
    return x > e ? 1 : x < -e ? -1 : 0;
}

/* The maximal number of sign changes over all choices of the uncertain signs. */
static int most_changes(const Form *form) {
    int first = sign_of(form, 0), up = first < 0 ? -1000 : 0, down = first > 0 ? -1000 : 0;
    for (int i = 1; i <= form->degree; i++) {
        int sign = sign_of(form, i), rises = down + 1 > up ? down + 1 : up, falls = up + 1 > down ? up + 1 : down;
        up = sign < 0 ? -1000 : rises;
        down = sign > 0 ? -1000 : falls;
    }
    return up > down ? up : down;
}

/* The parts to the left and right of SPLIT; `left` may be the form itself. */
static void split(const Form *form, Form *left, Form *right) {
    int n = form->degree;
    Form row = *form;
    left->degree = right->degree = n;
    for (int level = 0; level <= n; level++) {
        left->value[level] = row.value[0];
        left->error[level] = row.error[0];
        right->value[n - level] = row.value[n - level];
        right->error[n - level] = row.error[n - level];
        for (int i = 0; i < n - level; i++) {
            double first = (1 - SPLIT) * row.value[i], second = SPLIT * row.value[i + 1];
            double carried = (1 - SPLIT) * row.error[i] + SPLIT * row.error[i + 1];
            double rounding = 3 * ROUNDING * (fabs(first) + fabs(second));
            row.value[i] = first + second;
            row.error[i] = (carried + rounding) * (1 + 8 * ROUNDING) + 8 * UNDERFLOW;
        }
    }
}

/* The simple zeros inside a piece, in order: how many there are then, or -1 where that is not certain. */
static int isolated(Form *part, double low, double width, int level, Zero *found, int count, int room) {
    Form right;
    int first = sign_of(part, 0), most = most_changes(part);
    if (!first || !sign_of(part, part->degree))
        return -1;
    if (most == 0)
        return count;
    if (most == 1) {
        if (count == room)
            return -1;
        found[count] = (Zero){low, low + width, first};
        return count + 1;
    }
    if (level == DEPTH)
        return -1;
    split(part, part, &right);
    count = isolated(part, low, width * SPLIT, level + 1, found, count, room);
    return count < 0 ? -1 : isolated(&right, low + width * SPLIT, width * (1 - SPLIT), level + 1, found, count, room);
}

/* Whether a form certainly has one sign on a piece; `budget` bounds the pieces. */
static int without_zeros(Form *part, int level, int *budget) {
    Form right;
    int first = sign_of(part, 0), same = 1;
    if (!first || first != sign_of(part, part->degree))
        return 0;
    for (int i = 1; i < part->degree; i++)
        same &= sign_of(part, i) == first;
    if (same)
        return 1;
    if (level == DEEP || --*budget < 0)
        return 0;
    split(part, part, &right);
    return without_zeros(part, level + 1, budget) && without_zeros(&right, level + 1, budget);
}

/* The sign of a form at a parameter, 0 where it is not certain. */
static int sign_at(const Form *form, double t) {
    int n = form->degree;
    double b[MOST], e[MOST], u = 1 - t;
    for (int i = 0; i <= n; i++) {
        b[i] = form->value[i];
        e[i] = form->error[i] + 4 * (n + 1) * ROUNDING * fabs(b[i]);
    }
    for (int level = n; level > 0; level--)
        for (int i = 0; i < level; i++) {
            b[i] = u * b[i] + t * b[i + 1];
            e[i] = u * e[i] + t * e[i + 1];
        }
    double bound = e[0] * (1 + 8 * (n + 1) * ROUNDING) + 16 * (n + 1) * UNDERFLOW;
    return b[0] > bound ? 1 : b[0] < -bound ? -1 : 0;
}

/* An unproved approximation of a zero: Newton's method, or bisection where it leaves the bracket or is slow. */
static double approximated(const Form *form, const Zero *zero) {
    int n = form->degree;
    double low = zero->low, high = zero->high, x = (low + high) / 2, last = high - low, b[MOST];
    for (int step = 0; step < STEPS && last > REACHED; step++) {
        memcpy(b, form->value, (size_t)(n + 1) * sizeof(double));
        for (int level = n; level > 1; level--)
            for (int i = 0; i < level; i++)
                b[i] = (1 - x) * b[i] + x * b[i + 1];
        double value = (1 - x) * b[0] + x * b[1], move = value / (n * (b[1] - b[0])), near = x - move;
        if (value * zero->before > 0)
            low = x;
        else
            high = x;
        int good = near >= low && near <= high && 2 * fabs(move) <= last;
        last = good ? fabs(move) : (high - low) / 2;
        x = good ? near : (low + high) / 2;
    }
    return x;
}

/* The zero in a narrower interval, where the signs at its ends are certain. */
static void narrowed(const Form *form, Zero *zero) {
    double x = approximated(form, zero);
    for (int k = 0; k < (int)(sizeof WIDTHS / sizeof *WIDTHS); k++) {
        double a = fmax(zero->low, x - WIDTHS[k]), b = fmin(zero->high, x + WIDTHS[k]);
        if (a < b && sign_at(form, a) == zero->before && sign_at(form, b) == -zero->before) {
            zero->low = a;
            zero->high = b;
            return;
        }
    }
}

/* ---- a curve */


/* Whether a weight function, from rounded coefficients, is certainly positive. */
static int positive(const double *weights, int degree) {
    double mass[MOST];
    int budget = 1000;
    Form form;
    for (int i = 0; i <= degree; i++)
        mass[i] = fabs(weights[i]);
    ordinates(&form, degree, weights, mass, 8 * ROUNDING, 8 * UNDERFLOW);
    return form.value[0] > 0 && without_zeros(&form, 0, &budget);
}

/* A program and what it needs: `factors` are for every output the factor of its mass and the loss by underflow. */
typedef struct {
    int length, outputs, operands, degree, rational;
    const Instruction *code;
    const int *output;
    const double *factors;
} Program;

/* Every instruction of a program on one segment: where the results start, 0 where there is no room. */
static int ran(const Program *program, const double *data, int segment, int total, double *values, double *masses,
               int *starts) {
    static const double ONE[1] = {1};
    int used = 0, width = program->degree + 1;
    for (int k = 0; k < program->length; k++) {
        const Instruction *one = program->code + k;
        if (one->degree >= MOST || used + one->degree + 1 > ROOM)
            return 0;
        double *v = values + used, *m = masses + used;
        starts[k] = used;
        used += one->degree + 1;
        if (one->name == LOAD) {
            memcpy(v, data + one->a * total + segment * width, (size_t)width * sizeof(double));
            for (int i = 0; i < width; i++)
                m[i] = fabs(v[i]);
            continue;
        }
        int n = one->a < 0 ? 0 : program->code[one->a].degree, of_b = one->b < 0 ? 0 : program->code[one->b].degree;
        const double *a = one->a < 0 ? ONE : values + starts[one->a], *b = one->b < 0 ? ONE : values + starts[one->b];
        carried_out(one, v, a, n, b, of_b, 0);
        a = one->a < 0 ? ONE : masses + starts[one->a];
        b = one->b < 0 ? ONE : masses + starts[one->b];
        carried_out(one, m, a, n, b, of_b, 1);
    }
    return 1;
}

/* Divide numbers by a power of two so that none is larger than 1; exact, as all are 0 or between 2^-500 and 2^500. */
static void made_small(double *x, int count) {
    int size = -2000;
    for (int i = 0; i < count; i++) {
        int e;
        frexp(x[i], &e);
        if (x[i] != 0 && e > size)
            size = e;
    }
    for (int i = 0; i < count; i++)
        x[i] = x[i] == 0 ? 0 : ldexp(x[i], -size);
}

/* Run a program on the segments of a curve and find the zeros of its outputs except the last, which must have none.

   data: for every operand, segment and coefficient an integer, rounded, and then the denominators of the segments; where
   the program is `rational` the last operand is a weight function, which must be positive. It is overwritten.
   found: for every segment 1 where a zero is not certain, plus 2 where the absence of zeros of the last output or the
   sign of the weight function is not; for every output the ordinates at both ends, each followed
   by the bound of its error; and the weight function at both ends. Then for every zero: output, segment, the ends of an
   interval, and the sign before it, in the order of segments, outputs and parameters.

   Returns the number of zeros, -1 where numbers or programs are too large, -2 where there are more than `room` zeros. */
int filter_curve(const Program *program, double *data, int segments, double *found, int room) {
    static const double BIG = 0x1p500;
    int width = program->degree + 1, total = segments * width, coordinates = program->operands - program->rational;
    int outputs = program->outputs, stride = 3 + 4 * outputs, count = 0, starts[RESULTS];
    const double *below = data + program->operands * total;
    double values[ROOM], masses[ROOM];
    if (program->length > RESULTS || width > MOST)
        return -1;
    for (int i = 0; i < program->operands * total; i++) {
        double m = below[i % total / width];
        if (!(fabs(data[i]) < BIG && fabs(m) < BIG))
            return -1;
        data[i] /= m;
    }
    made_small(data, coordinates * total);
    if (program->rational)
        made_small(data + coordinates * total, total);
    double *zero = found + segments * stride;
    for (int s = 0; s < segments; s++) {
        double *here = found + s * stride;
        const double *weights = data + coordinates * total + s * width;
        int open = program->rational && !positive(weights, program->degree) ? 2 : 0;
        here[stride - 2] = program->rational ? weights[0] : 1;
        here[stride - 1] = program->rational ? weights[width - 1] : 1;
        if (!ran(program, data, s, total, values, masses, starts))
            return -1;
        for (int k = 0; k < outputs; k++) {
            int of = program->output[k], n = program->code[of].degree, budget = 1000;
            const double *factors = program->factors + 2 * k;
            Form form, copy;
            Zero own[MOST];
            ordinates(&form, n, values + starts[of], masses + starts[of], factors[0], factors[1]);
            copy = form;
            double *end = here + 1 + 4 * k;
            end[0] = form.value[0];
            end[1] = form.error[0];
            end[2] = form.value[n];
            end[3] = form.error[n];
            if (k == outputs - 1) {
                open |= without_zeros(&copy, 0, &budget) ? 0 : 2;
                continue;
            }
            int zeros = isolated(&copy, 0, 1, 0, own, 0, MOST);
            open |= zeros < 0;
            for (int i = 0; i < zeros; i++, count++, zero += 5) {
                if (count == room)
                    return -2;
                narrowed(&form, own + i);
                zero[0] = k;
                zero[1] = s;
                zero[2] = own[i].low;
                zero[3] = own[i].high;
                zero[4] = own[i].before;
            }
        }
        here[0] = open;
    }
    return count;
}
