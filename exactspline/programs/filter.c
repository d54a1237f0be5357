/* The certified filter in doubles with error masses. For one curve: a straight-line program on every segment, then the
   zeros of its outputs; the program is data (see accelerator.py). For two curves: the simple zeros of the determinant of
   Bézout's matrix (see exactspline/polynomials/bezout.py) and the parameters that belong to them; for higher degrees, and
   where that is not certain, the pieces of both that meet. What is not certain is said to be open and decided in exact
   arithmetic. Derivation: docs/certified-filter.md. At the end: points of a curve, in
   exact integers. */

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#if FLT_EVAL_METHOD != 0 || FLT_RADIX != 2 || DBL_MANT_DIG != 53 || DBL_MIN_EXP != -1021
#error "operations on doubles must round to doubles"
#endif
/* Parts of -ffast-math are refused one by one: each can be chosen alone. */
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || __FINITE_MATH_ONLY__ + 0
#error "operations on doubles must be carried out as they are written"
#endif
#ifdef __clang__
#pragma STDC FP_CONTRACT OFF
#endif

/* The most coefficients of a form (with more, binomial coefficients are not exact), numbers in the results of a program,
   and results. */
enum { MOST = 51, ROOM = 4096, RESULTS = 256 };
enum { LOAD, MUL, SUM, RAISE, DERIVE, DU, DV, OVER_U, SCALE };
/* The depths of subdivision, for isolation (up to FIRST at SPLIT, then at 1/2: the ends of pieces are exact) and to prove
   that there is no zero; the steps of Newton's method. */
enum { FIRST = 9, DEPTH = 17, DEEP = 22, STEPS = 40 };

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

/* The parts to the left and right of a parameter; `left` may be the form itself. */
static void split(const Form *form, double at, Form *left, Form *right) {
    int n = form->degree;
    Form row = *form;
    left->degree = right->degree = n;
    for (int level = 0; level <= n; level++) {
        left->value[level] = row.value[0];
        left->error[level] = row.error[0];
        right->value[n - level] = row.value[n - level];
        right->error[n - level] = row.error[n - level];
        for (int i = 0; i < n - level; i++) {
            double first = (1 - at) * row.value[i], second = at * row.value[i + 1];
            double carried = (1 - at) * row.error[i] + at * row.error[i + 1];
            double rounding = 3 * ROUNDING * (fabs(first) + fabs(second));
            row.value[i] = first + second;
            row.error[i] = (carried + rounding) * (1 + 8 * ROUNDING) + 8 * UNDERFLOW;
        }
    }
}

/* The simple zeros inside a piece, in order: how many there are then, or -1 where that is not certain. */
static int isolated(Form *part, double low, double width, int level, Zero *found, int count, int room) {
    Form right;
    double at = level < FIRST ? SPLIT : 0.5;
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
    split(part, at, part, &right);
    count = isolated(part, low, width * at, level + 1, found, count, room);
    return count < 0 ? -1 : isolated(&right, low + width * at, width * (1 - at), level + 1, found, count, room);
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
    split(part, SPLIT, part, &right);
    return without_zeros(part, level + 1, budget) && without_zeros(&right, level + 1, budget);
}

/* The value of a form at a parameter, and the bound of its error. */
static double value_at(const Form *form, double t, double *bound) {
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
    *bound = e[0] * (1 + 8 * (n + 1) * ROUNDING) + 16 * (n + 1) * UNDERFLOW;
    return b[0];
}

/* The sign of a form at a parameter, 0 where it is not certain. */
static int sign_at(const Form *form, double t) {
    double bound, value = value_at(form, t, &bound);
    return value > bound ? 1 : value < -bound ? -1 : 0;
}

/* Two forms of lower degree in the scaled basis between which a form is interpolated: the first and the last ordinates. */
static void halves(const Form *form, double *first, double *last) {
    binomials(first, form->degree - 1);
    for (int i = 0; i < form->degree; i++) {
        last[i] = first[i] * form->value[i + 1];
        first[i] *= form->value[i];
    }
}

/* Unproved approximations of a zero and of the derivative there: Newton's method, or bisection where it leaves the bracket
   or is slow. */
static double approximated(const double *first, const double *last, int n, const Zero *zero, double *slope) {
    double low = zero->low, high = zero->high, x = (low + high) / 2, latest = high - low;
    for (int step = 0; step < STEPS && latest > REACHED; step++) {
        double a = first[0], b = last[0], power = 1, value, move, near;
        for (int i = 1; i < n; i++) {
            power *= x;
            a = (1 - x) * a + power * first[i];
            b = (1 - x) * b + power * last[i];
        }
        value = (1 - x) * a + x * b;
        *slope = n * (b - a);
        move = value / *slope;
        near = x - move;
        if (value * zero->before > 0)
            low = x;
        else
            high = x;
        int good = near >= low && near <= high && 2 * fabs(move) <= latest;
        latest = good ? fabs(move) : (high - low) / 2;
        x = good ? near : (low + high) / 2;
    }
    return x;
}

/* The zero in a narrower interval, where the signs at its ends are certain: the first is as wide as errors suggest. */
static void narrowed(const Form *form, Zero *zero) {
    double first[MOST], last[MOST];
    halves(form, first, last);
    double slope = 0, error, x = approximated(first, last, form->degree, zero, &slope);
    value_at(form, x, &error);
    for (int k = -1; k < (int)(sizeof WIDTHS / sizeof *WIDTHS); k++) {
        double width = k < 0 ? fmax(2 * error / fabs(slope), 4 * ROUNDING) : WIDTHS[k];
        double a = fmax(zero->low, x - width), b = fmin(zero->high, x + width);
        if (a < b && sign_at(form, a) == zero->before && sign_at(form, b) == -zero->before) {
            zero->low = a;
            zero->high = b;
            return;
        }
    }
}

/* ---- a curve */

/* What is said of a segment: a zero is not certain; the absence of zeros of the last output, or the sign of the weight
   function, is not; a zero of the first output and one of another overlap. And of the knot at its start (for the first
   segment: the seam): the first output changes its sign there; the second does; and the curvatures of both sides certainly
   differ. The numbers of a segment beside those of its outputs, and of a zero. */
enum { OPEN = 1, SLOW = 2, ENTANGLED = 4, BENDS = 8, TURNS = 16, DIFFERENT = 32, BESIDE = 3, OF_ZERO = 4 };
/* Forms and weights below this are not used, since products of their powers could underflow; a bound of the relative error of
   a product of a dozen factors, the weight functions among them. */
static const double SMALL = 0x1p-60, PRODUCT = 0x1p-44;

/* Bounds of the squared curvature, from the numbers of the first output K and of the last one S at an end and the weight
   function there, up to a factor that both sides share: κ² is K² w⁶ / S³, whatever the parameter. */
static int squared(const double *first, const double *last, double w, double *bounds) {
    double k = fabs(first[0]), w3 = w * w * w, slow = last[0] - last[1], fast = last[0] + last[1];
    double low = (k - first[1]) * w3, high = (k + first[1]) * w3;
    bounds[0] = low * low / (fast * fast * fast) * (1 - PRODUCT);
    bounds[1] = high * high / (slow * slow * slow) * (1 + PRODUCT);
    return k - first[1] >= SMALL && slow >= SMALL && w >= SMALL;
}

/* What is said of the knot between two segments. */
static int joined(const double *before, const double *behind, int outputs) {
    const double *left = before + 3, *right = behind + 1;
    int last = 4 * (outputs - 1), beside = 4 * outputs, flags = 0;
    double one[2], other[2];
    for (int k = 0; k < 2 && k < outputs - 1; k++)
        flags |= (left[4 * k] > 0) == (right[4 * k] > 0) ? 0 : k ? TURNS : BENDS;
    if (squared(left, left + last, before[beside + 2], one) && squared(right, right + last, behind[beside + 1], other) &&
        (one[1] < other[0] || other[1] < one[0]))
        flags |= DIFFERENT;
    return flags;
}

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

/* Divide numbers by a power of two, whose exponent is returned, so that none is larger than 1; exact, as all are 0 or
   between 2^-500 and 2^500. */
static int made_small(double *x, int count) {
    int size = -2000;
    for (int i = 0; i < count; i++) {
        int e;
        frexp(x[i], &e);
        if (x[i] != 0 && e > size)
            size = e;
    }
    for (int i = 0; i < count; i++)
        x[i] = x[i] == 0 ? 0 : ldexp(x[i], -size);
    return size;
}

/* `filter_curve` with room for the results of a program, which is too large for the stack of a thread. */
static int filtered(const Program *program, double *data, int segments, double *found, int room, double *values,
                    double *masses) {
    static const double BIG = 0x1p500;
    int width = program->degree + 1, total = segments * width, coordinates = program->operands - program->rational;
    int outputs = program->outputs, stride = BESIDE + 4 * outputs, count = 0, all = 0, starts[RESULTS];
    const double *below = data + program->operands * total;
    if (program->length > RESULTS || width > MOST)
        return -1;
    for (int i = 0; i < program->operands * total; i++) {
        double m = below[i % total / width];
        if (!(fabs(data[i]) < BIG && fabs(m) < BIG && fabs(m) >= 1) || (data[i] != 0 && fabs(data[i]) * BIG < fabs(m)))
            return -1;
        data[i] /= m;
    }
    /* with a negative weight function the same curve in other homogeneous coordinates: forms of odd degree change their sign */
    if (program->rational && data[coordinates * total] < 0)
        for (int i = 0; i < program->operands * total; i++)
            data[i] = -data[i];
    made_small(data, coordinates * total);
    if (program->rational)
        made_small(data + coordinates * total, total);
    double *listed = found + outputs, *zero = listed + segments * stride;
    memset(found, 0, (size_t)outputs * sizeof(double));
    for (int s = 0; s < segments; s++) {
        double *here = listed + s * stride;
        Zero bends[MOST];
        int bent = 0;
        const double *weights = data + coordinates * total + s * width;
        int open = program->rational && !positive(weights, program->degree) ? SLOW : 0;
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
                open |= without_zeros(&copy, 0, &budget) ? 0 : SLOW;
                continue;
            }
            int zeros = isolated(&copy, 0, 1, 0, own, 0, MOST);
            open |= zeros < 0 ? OPEN : 0;
            for (int i = 0; i < zeros; i++, count++, zero += OF_ZERO) {
                if (count == room)
                    return -2;
                narrowed(&form, own + i);
                int sign = k && here[1] > 0;
                for (int j = 0; k && j < bent; j++) {
                    sign ^= bends[j].high <= own[i].low;
                    open |= bends[j].low < own[i].high && own[i].low < bends[j].high ? ENTANGLED : 0;
                }
                zero[0] = 4 * k + 2 * (own[i].before > 0) + sign;
                zero[1] = s;
                zero[2] = own[i].low;
                zero[3] = own[i].high;
                found[1 + k]++;
            }
            if (k == 0 && zeros > 0)
                memcpy(bends, own, (size_t)(bent = zeros) * sizeof(Zero));
        }
        here[0] = open;
    }
    for (int s = 0; s < segments; s++) {
        double *here = listed + s * stride;
        int flags = (int)here[0] | joined(listed + (s ? s - 1 : segments - 1) * stride, here, outputs);
        here[0] = flags;
        all |= s ? flags : flags & ~(BENDS | TURNS | DIFFERENT);
    }
    found[0] = all;
    return count;
}

/* Run a program on the segments of a curve and find the zeros of its outputs except the last, which must have none.

   data: for every operand, segment and coefficient a number, rounded, and then the denominators of the segments; where
   the program is `rational` the last operand is a weight function, which must have one sign. It is overwritten.
   found: what is said of any segment and knot, the seam apart, and the number of zeros of every output except the last. Then for every segment what
   is said of it; for every output the ordinates at both ends, each followed by the bound of its error; and the weight
   function at both ends. Then for every zero: four times its output, plus 2 where the sign before it is positive, plus 1
   where it is one of another output than the first, which is positive there; its segment; and the ends of an interval, in
   the order of segments, outputs and parameters.

   Returns the number of zeros, -1 where numbers or programs are too large, -2 where there are more than `room` zeros. */
int filter_curve(const Program *program, double *data, int segments, double *found, int room) {
    double *results = malloc(2 * ROOM * sizeof(double));
    int count = results ? filtered(program, data, segments, found, room, results, results + ROOM) : -1;
    free(results);
    return count;
}

/* ---- zeros to twice the precision */

/* A number as a sum of two doubles, the second of which is at most half a unit in the last place of the first. */
typedef struct {
    double high, low;
} Twice;

/* Whether operations are rounded to nearest: then the remainders of sums and products are doubles. */
static int to_nearest(void) {
    volatile double one = 1, half = 0x1p-53, more = 0x1.8p-53;
    return one + half == one && one + more > one;
}

/* The exact sum and the exact product of two doubles (Knuth, Dekker). */
static Twice sum_of(double a, double b) {
    double s = a + b, c = s - a;
    return (Twice){s, (a - (s - c)) + (b - c)};
}

static Twice product_of(double a, double b) {
    static const double PARTS = 0x1p27 + 1;
    double p = a * b, c = PARTS * a, d = PARTS * b, x = c - (c - a), y = d - (d - b);
    return (Twice){p, ((x * y - p) + x * (b - y) + (a - x) * y) + (a - x) * (b - y)};
}

/* With errors of at most 2^-102 times the sizes of the operands, or of their product. */
static Twice sum(Twice a, Twice b) {
    Twice s = sum_of(a.high, b.high);
    return sum_of(s.high, s.low + (a.low + b.low));
}

static Twice product(Twice a, Twice b) {
    Twice p = product_of(a.high, b.high);
    return sum_of(p.high, p.low + (a.high * b.low + a.low * b.high));
}

/* A number to twice the precision, and a bound of its error. */
typedef struct {
    Twice value;
    double error;
} Near;

/* The most derivatives of a form that are needed, and one more; how often a zero is enclosed more closely. */
enum { ORDERS = 4, REPEATED = 4 };
/* Bounds of the error of an operation: relative to the sizes of the operands, and absolute, by underflow. */
static const double OF_TWICE = 0x1p-100, TINY = 0x1p-900;

static Near near_to(double high, double low) {
    return (Near){sum_of(high, low), OF_TWICE * fabs(high) + TINY};
}

static Near near_sum(Near a, Near b) {
    double own = OF_TWICE * (fabs(a.value.high) + fabs(b.value.high)) + TINY;
    return (Near){sum(a.value, b.value), a.error + b.error + own};
}

static Near near_product(Near a, Near b) {
    double x = fabs(a.value.high), y = fabs(b.value.high);
    double carried = x * b.error + y * a.error + a.error * b.error;
    return (Near){product(a.value, b.value), 2 * carried + OF_TWICE * x * y + TINY};
}

/* A multiple by a double. */
static Near near_times(double m, Near a) {
    return near_product((Near){{m, 0}, 0}, a);
}

/* The most operands. What is known on one segment: the results of a program in doubles, its coefficients and those of their
   derivatives, and at one point of every result the value and the derivatives. */
enum { OPERANDS = 3 };
typedef struct {
    double values[ROOM], masses[ROOM];
    Near loaded[OPERANDS][ORDERS][MOST], jets[RESULTS][ORDERS];
} Closer;

/* The coefficients of an operand and of its derivatives in the direction (−1, 1). */
static void loaded_from(const double *high, const double *low, int degree, Near (*to)[MOST]) {
    for (int i = 0; i <= degree; i++)
        to[0][i] = near_to(high[i], low[i]);
    for (int k = 1; k < ORDERS; k++)
        for (int i = 0; i <= degree - k; i++)
            to[k][i] = near_sum(near_times(i + 1, to[k - 1][i + 1]), near_times(i - degree + k - 1, to[k - 1][i]));
}

/* The value of a form, by coefficients, where the powers of v are known; 0 for one of negative degree. */
static Near near_value(const Near *c, int n, Near u, const Near *powers) {
    Near value = n < 0 ? (Near){{0, 0}, 0} : c[0];
    for (int i = 1; i <= n; i++)
        value = near_sum(near_product(value, u), near_product(c[i], powers[i]));
    return value;
}

/* How many derivatives of each result are needed for one output without derivatives, -1 where the result is not needed:
   0 where there are too many. */
static int orders_for(const Program *program, int output, int *orders) {
    for (int k = 0; k < program->length; k++)
        orders[k] = k == program->output[output] ? 0 : -1;
    for (int k = program->length - 1; k >= 0; k--) {
        const Instruction *one = program->code + k;
        int order = orders[k] + (one->name == DERIVE || one->name == DU || one->name == DV);
        if (orders[k] < 0 || one->name == LOAD)
            continue;
        if (order >= ORDERS || (one->name == OVER_U && order))
            return 0;
        if (one->a >= 0 && orders[one->a] < order)
            orders[one->a] = order;
        if ((one->name == MUL || one->name == SUM) && one->b >= 0 && orders[one->b] < order)
            orders[one->b] = order;
    }
    return 1;
}

/* An output at (1 − t, t). */
static Near output_at(const Program *program, int output, const int *orders, double t, Closer *own) {
    static const Near ONE[ORDERS] = {{{1, 0}, 0}};
    static const double TIMES[ORDERS][ORDERS] = {{1}, {1, 1}, {1, 2, 1}, {1, 3, 3, 1}};
    Near u = {sum_of(1, -t), 0}, v = {{t, 0}, 0}, minus = {{-t, 0}, 0}, powers[MOST] = {{{1, 0}, 0}};
    for (int i = 1; i <= program->degree; i++)
        powers[i] = near_product(powers[i - 1], v);
    for (int k = 0; k <= program->output[output]; k++) {
        const Instruction *one = program->code + k;
        const Near *a = one->name == LOAD || one->a < 0 ? ONE : own->jets[one->a], *b = one->b < 0 ? ONE : own->jets[one->b];
        int n = one->name == LOAD || one->a < 0 ? 0 : program->code[one->a].degree;
        for (int order = 0; order <= orders[k]; order++) {
            Near *to = &own->jets[k][order];
            switch (one->name) {
            case LOAD:
                *to = near_value(own->loaded[one->a][order], program->degree - order, u, powers);
                break;
            case MUL:
                *to = near_product(a[0], b[order]);
                for (int i = 1; i <= order; i++)
                    *to = near_sum(*to, near_product(near_times(TIMES[order][i], a[i]), b[order - i]));
                break;
            case SUM:
                *to = near_sum(near_times(one->m, a[order]), near_times(one->n, b[order]));
                break;
            case RAISE:
                *to = a[order];
                break;
            case DERIVE:
                *to = a[order + 1];
                break;
            case DU:
                *to = near_sum(near_times(n - order, a[order]), near_product(minus, a[order + 1]));
                break;
            case DV:
                *to = near_sum(near_times(n - order, a[order]), near_product(u, a[order + 1]));
                break;
            case OVER_U:
                to->value = (Twice){a->value.high / u.value.high, 0};
                to->error = 2 * (a->error + fabs(a->value.low)) / u.value.high + 4 * ROUNDING * fabs(to->value.high) + TINY;
                break;
            default:
                *to = near_times(one->m, a[order]);
            }
        }
    }
    return own->jets[program->output[output]][0];
}

/* The value of a form at a parameter, and a bound of its distance from all values over an interval that begins there. */
static double value_over(const Form *form, double low, double high, double *bound) {
    int n = form->degree;
    double steep = 0, value = value_at(form, low, bound);
    for (int i = 0; i < n; i++)
        steep = fmax(steep, fabs(form->value[i + 1] - form->value[i]) + form->error[i] + form->error[i + 1]);
    *bound = (*bound + n * steep * (high - low)) * (1 + 16 * ROUNDING);
    return value;
}

/* The zero of a form in an interval by one step of the interval Newton method from the value in the middle, which proves
   once more that there is one: 0 where it does not. */
static int closer_zero(const Form *form, double low, double high, double middle, Near value, Near *zero) {
    Form slope;
    int n = slope.degree = form->degree - 1;
    for (int i = 0; i <= n; i++) {
        slope.value[i] = (n + 1) * (form->value[i + 1] - form->value[i]);
        slope.error[i] = (n + 1) * (form->error[i] + form->error[i + 1]) * (1 + 8 * ROUNDING) +
                         4 * ROUNDING * fabs(slope.value[i]) + UNDERFLOW;
    }
    double bound, steep = value_over(&slope, low, high, &bound), least = (fabs(steep) - bound) * (1 - 8 * ROUNDING);
    if (n < 0 || !(least > 0))
        return 0;
    double move = -value.value.high / steep, off = value.error + fabs(value.value.low);
    double error = 2 * ((fabs(move) * bound + off) / least + 4 * ROUNDING * fabs(move)) + TINY;
    *zero = (Near){sum_of(middle, move), error};
    return fmin((middle - low) + move, (high - middle) - move) > 2 * error + 8 * ROUNDING * (high - low);
}

/* The double nearest to a parameter over an interval, each of whose ends is a double near it and the difference from it;
   not a number where that is not certain, and at zero. */
static double nearest_over(const double *ends, const double *off, Near t) {
    Near a = near_to(ends[0], off[0]), minus = near_to(-ends[0], -off[0]), width = near_sum(near_to(ends[1], off[1]), minus);
    Near x = near_sum(a, near_product(width, t));
    double error = 2 * x.error + OF_TWICE * fabs(x.value.high);
    double low = x.value.high + (x.value.low - error), high = x.value.high + (x.value.low + error);
    return low == high && low != 0 && fabs(low) <= DBL_MAX ? low : NAN;
}

/* `filter_doubles` with its room. */
static int rounded(const Program *program, const double *data, const double *rest, const double *zeros, const double *ends,
                   const double *off, double *nearest, int segments, int count, Closer *room) {
    static const double BIG = 0x1p500;
    double high[OPERANDS * MOST], low[OPERANDS * MOST];
    int width = program->degree + 1, total = segments * width, coordinates = program->operands - program->rational;
    int starts[RESULTS], orders[RESULTS], last = -1, of = -1;
    if (program->length > RESULTS || width > MOST || program->operands > OPERANDS || !to_nearest())
        return -1;
    for (int i = 0; i < count; i++) {
        const double *own = zeros + OF_ZERO * i;
        int output = (int)own[0] / 4, segment = (int)(own[1] - zeros[1]), used = coordinates * width;
        nearest[i] = NAN;
        if (segment < 0 || segment >= segments || output < 0 || output >= program->outputs)
            return -1;
        if (segment != last) {
            for (int k = 0; k < program->operands * width; k++) {
                int from = k / width * total + segment * width + k % width;
                high[k] = data[from];
                low[k] = rest ? rest[from] : 0;
                if (!(fabs(high[k]) < BIG && fabs(low[k]) < BIG) || (high[k] != 0 && fabs(high[k]) * BIG < 1))
                    return -1;
            }
            int first = made_small(high, used), second = made_small(high + used, program->operands * width - used);
            for (int k = 0; k < program->operands * width; k++)
                low[k] = ldexp(low[k], k < used ? -first : -second);
            if (!ran(program, high, 0, width, room->values, room->masses, starts))
                return -1;
            for (int k = 0; k < program->operands; k++)
                loaded_from(high + k * width, low + k * width, program->degree, room->loaded[k]);
            last = segment;
            of = -1;
        }
        if (output != of && !orders_for(program, output, orders))
            return -1;
        Form form;
        Near t;
        int at = program->output[output];
        double from = own[2], to = own[3];
        ordinates(&form, program->code[at].degree, room->values + starts[at], room->masses + starts[at],
                  program->factors[2 * output], program->factors[2 * output + 1]);
        for (int step = 0; step < REPEATED && isnan(nearest[i]); step++) {
            double middle = (from + to) / 2;
            if (!closer_zero(&form, from, to, middle, output_at(program, output, orders, middle, room), &t))
                break;
            nearest[i] = nearest_over(ends + segment, off + segment, t);
            double around = t.error + 4 * ROUNDING * fabs(t.value.high);
            from = fmax(from, t.value.high - around);
            to = fmin(to, t.value.high + around);
        }
        of = output;
    }
    return count;
}

/* The doubles nearest to the parameters of zeros that `filter_curve` has found.

   data: for every operand, segment and coefficient a number, rounded, from the segment of the first of these zeros on.
   rest: the differences from the numbers, each rounded once; absent where there are none.
   zeros: as in `filter_curve`.
   ends, off: for each end of a segment a double near its parameter, and the difference from it, rounded once.
   nearest: for each zero the double; not a number where it is not certain.

   Returns the number of zeros, -1 where numbers or programs are too large, or doubles are not rounded to nearest. */
int filter_doubles(const Program *program, const double *data, const double *rest, const double *zeros, const double *ends,
                   const double *off, double *nearest, int segments, int count) {
    Closer *room = malloc(sizeof *room);
    int known = room ? rounded(program, data, rest, zeros, ends, off, nearest, segments, count, room) : -1;
    free(room);
    return known;
}

/* ---- two curves */

/* The highest degree of a segment; the numbers of one: its degree, a box around it, a point near it, and then the
   coefficients of x, y and w measured from this point; those of a common point, and how many there are at most. */
enum { HIGHEST = 12, SIDE = HIGHEST + 1, BOX = 1, MIDDLE = 5, ROWS = 7, OF_POINT = 6, POINTS_OF_PAIR = 36 };
/* The highest degree of segments whose determinant is computed; the sets of columns of its matrix, and its coefficients. */
enum { ELIMINATED = 5, COLUMNS = 1 << ELIMINATED, LONG = ELIMINATED * ELIMINATED + 1 };

/* The coefficients of a form in the scaled basis, each with its mass. */
typedef struct {
    double value[LONG], mass[LONG];
} Bare;

/* The coefficients of the coordinates x, y, w of a segment, with their masses. */
typedef struct {
    int degree;
    double value[3][SIDE], mass[3][SIDE];
} Points;

/* A matrix of forms in the parameter of the second curve; the roundings of its entries. */
typedef struct {
    int size, degree, roundings;
    Bare entry[ELIMINATED][ELIMINATED];
} Matrix;

/* The room of an elimination, which is not on the stack: the matrix, and its minors. */
typedef struct {
    Matrix matrix;
    Bare minors[COLUMNS];
} Room;

/* How many numbers a segment of a table has, all of whose segments are of one degree: 0 where this is not from 1 to
   `HIGHEST`. */
static int numbers_of_each(const double *table, int before, int coefficient) {
    return table[0] >= 1 && table[0] <= HIGHEST ? before + 3 * coefficient * ((int)table[0] + 1) : 0;
}

/* Whether the boxes of two segments, whose ends are rounded once, certainly have no point in common. */
static int apart(const double *a, const double *b) {
    for (int k = BOX; k < MIDDLE; k += 2)
        if (b[k] - a[k + 1] > 8 * ROUNDING * (fabs(b[k]) + fabs(a[k + 1])) + 8 * UNDERFLOW ||
            a[k] - b[k + 1] > 8 * ROUNDING * (fabs(a[k]) + fabs(b[k + 1])) + 8 * UNDERFLOW)
            return 1;
    return 0;
}

/* Both segments in one system of coordinates, no number larger than the binomial coefficients: 0 where they are too
   large or too small for that. The first goes through 1 rounding, the second through 4. */
static int brought_together(const double *first, const double *second, Points *p, Points *q) {
    static const double BIG = 0x1p400, SMALL = 0x1p-400;
    const double *given[2] = {first, second};
    Points *to[2] = {p, q};
    double unit[2], shift[2], far = 0;
    for (int c = 0; c < 2; c++)
        shift[c] = second[MIDDLE + c] - first[MIDDLE + c];
    for (int k = 0; k < 2; k++) {
        double weight = 0, size = 0;
        int e, n = (int)given[k][0], side = n + 1;
        /* a maximum does not notice what is not a number */
        for (int i = BOX; i < ROWS + 3 * side; i++)
            if (!(fabs(given[k][i]) <= DBL_MAX))
                return 0;
        for (int i = 0; i <= n; i++)
            weight = fmax(weight, fabs(given[k][ROWS + 2 * side + i]));
        if (!(weight < BIG && weight > SMALL))
            return 0;
        frexp(weight, &e);
        unit[k] = ldexp(1, -e);
        for (int i = 0; i <= n; i++)
            for (int c = 0; c < 2; c++)
                size = fmax(size, fabs(given[k][ROWS + c * side + i]) * unit[k]);
        far = fmax(far, k ? size + fmax(fabs(shift[0]), fabs(shift[1])) : size);
    }
    if (!(far < BIG && far > SMALL))
        return 0;
    int e;
    frexp(far, &e);
    double scale = ldexp(1, -e);
    for (int k = 0; k < 2; k++) {
        int side = (int)given[k][0] + 1;
        to[k]->degree = side - 1;
        for (int i = 0; i < side; i++) {
            double w = given[k][ROWS + 2 * side + i] * unit[k];
            to[k]->value[2][i] = w;
            to[k]->mass[2][i] = fabs(w);
            for (int c = 0; c < 2; c++) {
                double x = given[k][ROWS + c * side + i] * unit[k] * scale, moved = k ? shift[c] * scale * w : 0;
                to[k]->value[c][i] = x + moved;
                to[k]->mass[c][i] = fabs(x) + fabs(moved);
            }
        }
    }
    return 1;
}

/* The line through two points: 2 roundings more than those of both. */
static void line_through(const double *a, const double *b, double *line, const double *a_mass, const double *b_mass,
                         double *mass) {
    for (int c = 0; c < 3; c++) {
        int d = (c + 1) % 3, e = (c + 2) % 3;
        line[c] = a[d] * b[e] - a[e] * b[d];
        mass[c] = a_mass[d] * b_mass[e] + a_mass[e] * b_mass[d];
    }
}

/* A line at the points of a segment: 3 roundings more than those of both. */
static void line_along(const double *line, const double *mass, const Points *q, Bare *form) {
    for (int i = 0; i <= q->degree; i++) {
        form->value[i] = line[0] * q->value[0][i] + line[1] * q->value[1][i] + line[2] * q->value[2][i];
        form->mass[i] = mass[0] * q->mass[0][i] + mass[1] * q->mass[1][i] + mass[2] * q->mass[2][i];
    }
}

static void point_of(const Points *p, int i, double *point, double *mass) {
    for (int c = 0; c < 3; c++) {
        point[c] = p->value[c][i];
        mass[c] = p->mass[c][i];
    }
}

static void cleared(Bare *form, int degree) {
    memset(form->value, 0, (size_t)(degree + 1) * sizeof(double));
    memset(form->mass, 0, (size_t)(degree + 1) * sizeof(double));
}

/* Bézout's matrix of the first segment and a point on the second. */
static void bezout(const Points *p, const Points *q, Matrix *matrix) {
    int m = p->degree;
    matrix->size = m;
    matrix->degree = q->degree;
    /* two points of one rounding, a line, a point of four; the sum of up to three of these */
    matrix->roundings = (1 + 1 + 2) + 4 + 3 + 2;
    for (int i = 0; i < m; i++)
        for (int j = 0; j < m; j++)
            cleared(&matrix->entry[i][j], q->degree);
    for (int i = 0; i < m; i++)
        for (int j = i + 1; j <= m; j++) {
            double a[3], b[3], line[3], a_mass[3], b_mass[3], mass[3];
            Bare form;
            point_of(p, i, a, a_mass);
            point_of(p, j, b, b_mass);
            line_through(a, b, line, a_mass, b_mass, mass);
            line_along(line, mass, q, &form);
            /* (σⁱ sʲ − σʲ sⁱ)/(s − σ) has the terms σᵏ sˡ with k + l = i + j − 1 and i ≤ k, l */
            for (int k = i; k < j; k++)
                for (int t = 0; t <= q->degree; t++) {
                    matrix->entry[k][i + j - 1 - k].value[t] += form.value[t];
                    matrix->entry[k][i + j - 1 - k].mass[t] += form.mass[t];
                }
        }
}

static void add_product(Bare *to, int sign, const Bare *a, int p, const Bare *b, int q) {
    for (int i = 0; i <= p; i++) {
        double x = sign * a->value[i], size = a->mass[i];
        for (int j = 0; j <= q; j++) {
            to->value[i + j] += x * b->value[j];
            to->mass[i + j] += size * b->mass[j];
        }
    }
}

/* The minors of the last rows and each set of columns, and the roundings of those of every size. */
static void expanded(const Matrix *matrix, Bare *minors, int *roundings) {
    int m = matrix->size, n = matrix->degree, size[COLUMNS] = {0};
    minors[0].value[0] = minors[0].mass[0] = 1;
    roundings[0] = 0;
    for (int set = 1; set < 1 << m; set++) {
        size[set] = size[set >> 1] + (set & 1);
        int degree = n * (size[set] - 1), terms = size[set] * ((degree < n ? degree : n) + 1), sign = 1;
        const Bare *row = matrix->entry[m - size[set]];
        cleared(minors + set, degree + n);
        for (int j = 0; j < m; j++)
            if (set >> j & 1) {
                add_product(minors + set, sign, row + j, n, minors + (set & ~(1 << j)), degree);
                sign = -sign;
            }
        roundings[size[set]] = roundings[size[set] - 1] + matrix->roundings + terms;
    }
}

/* Numbers and masses stay below 2^200, and there are fewer than 2^20 operations: underflow loses less than this. */
static const double LOST = 0x1p-600, SLACK = 1.0625;

static void bounded(Form *form, int degree, const Bare *bare, int roundings) {
    ordinates(form, degree, bare->value, bare->mass, SLACK * roundings * ROUNDING, LOST);
}

/* Three forms in the parameter of the second segment: one that vanishes where it meets the first curve, and two with the
   ratio of s and 1 − s there. */
static void eliminated(const Points *p, const Points *q, Room *own, Form *vanishing, Form *top, Form *bottom) {
    const Matrix *matrix = &own->matrix;
    Bare *minors = own->minors;
    bezout(p, q, &own->matrix);
    int m = p->degree, n = q->degree, roundings[ELIMINATED + 1];
    if (m == 1) {
        /* with the line l of p₀ and p₁: (l × p₀)·Q and (p₁ × l)·Q */
        double a[3], b[3], line[3], across[3], a_mass[3], b_mass[3], mass[3], across_mass[3];
        Bare form;
        point_of(p, 0, a, a_mass);
        point_of(p, 1, b, b_mass);
        line_through(a, b, line, a_mass, b_mass, mass);
        line_through(line, a, across, mass, a_mass, across_mass);
        line_along(across, across_mass, q, &form);
        bounded(top, n, &form, (4 + 1 + 2) + 4 + 3);
        line_through(b, line, across, b_mass, mass, across_mass);
        line_along(across, across_mass, q, &form);
        bounded(bottom, n, &form, (4 + 1 + 2) + 4 + 3);
        bounded(vanishing, n, &matrix->entry[0][0], matrix->roundings);
        return;
    }
    expanded(matrix, minors, roundings);
    int all = (1 << m) - 1;
    bounded(vanishing, m * n, minors + all, roundings[m]);
    /* the entries A₀₀ and A₀₁ of the adjugate */
    bounded(bottom, (m - 1) * n, minors + (all & ~1), roundings[m - 1]);
    bounded(top, (m - 1) * n, minors + (all & ~2), roundings[m - 1]);
    for (int i = 0; i <= top->degree; i++)
        top->value[i] = -top->value[i];
}

/* Divide the rows, or the columns, of a matrix by s − t from the highest power of s down, up to the degree m − 2 in t:
   what is left out cancels. Each entry is a sum of at most m − 1 of those that were there. */
static void divided(Matrix *matrix, int columns) {
    int m = matrix->size;
    for (int k = 0; k < m; k++)
        for (int j = m - 2; j > 0; j--) {
            Bare *to = columns ? &matrix->entry[k][j] : &matrix->entry[j][k];
            const Bare *from = columns ? &matrix->entry[k][j + 1] : &matrix->entry[j + 1][k];
            for (int l = 1; l <= m - 2; l++) {
                to->value[l] += from->value[l - 1];
                to->mass[l] += from->mass[l - 1];
            }
        }
}

/* The same three forms for a segment, given twice, of degree 2 or more, without the pairs of equal parameters. */
static void eliminated_itself(const Points *p, const Points *q, Room *own, Form *vanishing, Form *top, Form *bottom) {
    Matrix *matrix = &own->matrix;
    Bare *minors = own->minors;
    int m = p->degree, all = (1 << (m - 1)) - 1, roundings[ELIMINATED + 1];
    bezout(p, q, matrix);
    divided(matrix, 1);
    divided(matrix, 0);
    for (int i = 1; i < m; i++)
        for (int j = 1; j < m; j++)
            matrix->entry[i - 1][j - 1] = matrix->entry[i][j];
    matrix->size = m - 1;
    matrix->degree = m - 2;
    matrix->roundings += 2 * m;
    expanded(matrix, minors, roundings);
    bounded(vanishing, (m - 1) * (m - 2), minors + all, roundings[m - 1]);
    bounded(bottom, (m - 2) * (m - 2), minors + (all & ~1), roundings[m - 2]);
    bounded(top, (m - 2) * (m - 2), minors + (all & ~2), roundings[m - 2]);
    for (int i = 0; i <= top->degree; i++)
        top->value[i] = -top->value[i];
}

/* Where a zero of the determinant lies on the first curve: 1 on the segment, with bounds of the parameter, -1 outside, 0
   where that is not certain. */
static int place_on_first(const Form *top, const Form *bottom, const Zero *zero, double *bounds) {
    double over, under, a = value_over(top, zero->low, zero->high, &over);
    double b = value_over(bottom, zero->low, zero->high, &under);
    if (!(fabs(a) > over && fabs(b) > under))
        return 0;
    if ((a > 0) != (b > 0))
        return -1;
    a = fabs(a);
    b = fabs(b);
    bounds[0] = (a - over) / ((a - over) + (b + under)) * (1 - 8 * ROUNDING);
    bounds[1] = fmin(1, (a + over) / ((a + over) + (b - under)) * (1 + 8 * ROUNDING));
    return 1;
}

/* The segment in the other direction. */
static void turned_round(Points *p) {
    for (int c = 0; c < 3; c++)
        for (int i = 0, j = p->degree; i < j; i++, j--) {
            double value = p->value[c][i], mass = p->mass[c][i];
            p->value[c][i] = p->value[c][j];
            p->mass[c][i] = p->mass[c][j];
            p->value[c][j] = value;
            p->mass[c][j] = mass;
        }
}

/* The common points of two segments, as in `filter_pair`: how many there are, or -1 where a parameter of the first is not
   certain, which may help to reverse it, -2 where something else is not. What is found is that of the first as it was
   before it was `reversed`, and of segments as they were before they were `exchanged`. Of a segment and `itself` the first
   parameter is the smaller. */
static int met(const Points *p, const Points *q, Room *own, int reversed, int exchanged, int itself, double *point) {
    Form vanishing, top, bottom, copy;
    Zero zeros[MOST];
    if (itself && p->degree < 2)
        return -2;
    (itself ? eliminated_itself : eliminated)(p, q, own, &vanishing, &top, &bottom);
    copy = vanishing;
    int inside = isolated(&copy, 0, 1, 0, zeros, 0, MOST), count = 0;
    for (int i = 0; i < inside; i++) {
        double bounds[2];
        narrowed(&vanishing, zeros + i);
        int place = place_on_first(&top, &bottom, zeros + i, bounds);
        if (itself && place > 0 && bounds[0] > zeros[i].high)
            continue;
        if (itself && !(place < 0 || (place > 0 && bounds[1] < zeros[i].low)))
            return -2;
        if (place == 0)
            return -1;
        if (place < 0)
            continue;
        double *here = point + OF_POINT * count++, *own_part = here + (exchanged ? 0 : 2), *other = here + (exchanged ? 2 : 0);
        own_part[0] = zeros[i].low;
        own_part[1] = zeros[i].high;
        other[0] = reversed ? fmax(0, 1 - bounds[1] - ROUNDING) : bounds[0];
        other[1] = reversed ? fmin(1, 1 - bounds[0] + ROUNDING) : bounds[1];
        here[4] = reversed && p->degree % 2 ? -zeros[i].before : zeros[i].before;
        here[5] = i;
    }
    return inside < 0 ? -2 : count;
}

/* `met` by the determinant of two segments; -1 where something is not certain. */
static int by_determinant(const double *one, const double *other, int itself, double *found) {
    int exchanged = one[0] > other[0], known = -2;
    Points p, q;
    Room *own = malloc(sizeof *own);
    if (own && brought_together(exchanged ? other : one, exchanged ? one : other, &p, &q))
        known = met(&p, &q, own, 0, exchanged, itself, found);
    if (known == -1) {
        turned_round(&p);
        known = met(&p, &q, own, 1, exchanged, 0, found);
    }
    free(own);
    return known < 0 ? -1 : known;
}

/* ---- two curves by their pieces */

/* How often a segment is halved, how many pairs of pieces are compared, and how often a step of Newton's method is taken. */
enum { HALVINGS = 20, COMPARED = 300, NEWTON = 8 };
/* The error of a parameter of a piece on its segment; a distance from an end of the segment at which no point is certain;
   half the widths of the intervals of a common point. */
static const double PLACED = 0x1p-44, AT_END = 0x1p-40, HALVES[] = {0x1p-42, 0x1p-36, 0x1p-28, 0x1p-18};

/* A piece of a segment, which is halved `level` times: where it begins there, and how long it is; the Bézier ordinates of x,
   y and w, and bounds of the error of each; its control points, a bound of the error of all, the largest size, and the ends
   of a box. */
typedef struct {
    int degree, level;
    double low, width, row[3][SIDE], error[3], point[2][SIDE], off[2], size[2], least[2], most[2];
} Piece;

/* The pieces that are being compared, and what is found. */
typedef struct {
    Piece pieces[2 * HALVINGS + 4][2];
    int compared, count;
    double *found;
} Search;

/* Find the control points of a piece: 0 where a weight is not certainly positive. */
static int located(Piece *p) {
    double weight = p->row[2][0];
    for (int i = 1; i <= p->degree; i++)
        weight = fmin(weight, p->row[2][i]);
    double least = (weight - p->error[2]) * (1 - 4 * ROUNDING);
    if (!(least > weight / 2))
        return 0;
    for (int c = 0; c < 2; c++) {
        double low = DBL_MAX, high = -DBL_MAX;
        for (int i = 0; i <= p->degree; i++) {
            double x = p->point[c][i] = p->row[c][i] / p->row[2][i];
            low = fmin(low, x);
            high = fmax(high, x);
        }
        double size = p->size[c] = fmax(-low, high);
        double off = p->off[c] = (p->error[c] + size * p->error[2]) / least * (1 + 16 * ROUNDING) + 2 * ROUNDING * size + TINY;
        p->least[c] = low - (off + 2 * ROUNDING * size);
        p->most[c] = high + (off + 2 * ROUNDING * size);
    }
    return 1;
}

/* The whole of a segment whose coefficients went through so many roundings. */
static int whole(const Points *given, int roundings, Piece *p) {
    int n = p->degree = given->degree;
    double scale[SIDE], sign = given->value[2][0] < 0 ? -1 : 1;
    binomials(scale, n);
    p->level = 0;
    p->low = 0;
    p->width = 1;
    for (int c = 0; c < 3; c++) {
        p->error[c] = 0;
        for (int i = 0; i <= n; i++) {
            double x = p->row[c][i] = sign * given->value[c][i] / scale[i];
            double error = (given->mass[c][i] * (SLACK * roundings * ROUNDING) + LOST) / scale[i] * (1 + 8 * ROUNDING);
            p->error[c] = fmax(p->error[c], error + 2 * ROUNDING * fabs(x) + UNDERFLOW);
        }
    }
    return located(p);
}

/* The parts of a piece to the left and right of a parameter of its own, without their control points. */
static void divided_at(const Piece *p, double at, Piece *left, Piece *right) {
    int n = p->degree;
    double u = 1 - at;
    left->degree = right->degree = n;
    left->level = right->level = p->level + 1;
    left->low = p->low;
    left->width = p->width * at;
    right->low = p->low + left->width;
    right->width = p->width * u;
    for (int c = 0; c < 3; c++) {
        double row[SIDE], size = 0;
        for (int i = 0; i <= n; i++)
            size = fmax(size, fabs(row[i] = p->row[c][i]));
        for (int level = 0; level <= n; level++) {
            left->row[c][level] = row[0];
            right->row[c][n - level] = row[n - level];
            for (int i = 0; i < n - level; i++)
                row[i] = u * row[i] + at * row[i + 1];
        }
        left->error[c] = right->error[c] = (p->error[c] + 4 * n * ROUNDING * size) * (1 + 4 * ROUNDING) + TINY;
    }
}

/* Both halves of a piece: 0 where they are not certain. */
static int halved(const Piece *p, Piece *left, Piece *right) {
    divided_at(p, SPLIT, left, right);
    return p->level < HALVINGS && located(left) && located(right);
}

/* The part of a piece between two parameters of its own. */
static int part(const Piece *p, double from, double to, Piece *own) {
    Piece rest, other;
    divided_at(p, to, &rest, &other);
    divided_at(&rest, from / to, &other, own);
    return located(own);
}

/* A vector from the first control point of a piece to the last, and one at right angles to it. */
static void chord_of(const Piece *p, double *chord, double *normal) {
    for (int c = 0; c < 2; c++)
        chord[c] = p->point[c][p->degree] - p->point[c][0];
    normal[0] = -chord[1];
    normal[1] = chord[0];
}

/* The values of a linear form at the control points from the k-th to the l-th: the least and the largest, certainly. */
static void values_of(const double *form, const Piece *p, int k, int l, double *ends) {
    double low = DBL_MAX, high = -DBL_MAX, error = TINY;
    for (int i = k; i <= l; i++) {
        double x = form[0] * p->point[0][i] + form[1] * p->point[1][i];
        low = fmin(low, x);
        high = fmax(high, x);
    }
    for (int c = 0; c < 2; c++)
        error += fabs(form[c]) * (p->off[c] + 8 * ROUNDING * p->size[c]) * (1 + 8 * ROUNDING);
    ends[0] = low - error;
    ends[1] = high + error;
}

/* Whether two pieces certainly have no common point: boxes, or strips along their chords, are apart. */
static int separated(const Piece *p, const Piece *q) {
    for (int c = 0; c < 2; c++)
        if (p->least[c] > q->most[c] || q->least[c] > p->most[c])
            return 1;
    for (int k = 0; k < 2; k++) {
        double chord[2], normal[2], one[2], other[2];
        chord_of(k ? q : p, chord, normal);
        values_of(normal, p, 0, p->degree, one);
        values_of(normal, q, 0, q->degree, other);
        if (one[0] > other[1] || other[0] > one[1])
            return 1;
    }
    return 0;
}

/* The vectors from each control point of a piece to the next, their largest sizes, and a bound of their errors. */
static void legs_of(const Piece *p, double (*leg)[SIDE], double *size, double *off) {
    for (int c = 0; c < 2; c++) {
        size[c] = 0;
        for (int i = 0; i < p->degree; i++)
            size[c] = fmax(size[c], fabs(leg[c][i] = p->point[c][i + 1] - p->point[c][i]));
        off[c] = 2 * p->off[c] + 2 * ROUNDING * size[c] + UNDERFLOW;
    }
}

/* Whether all legs of one piece certainly are on one side of all legs of the other: then the pieces have at most one common
   point, where their tangents differ. */
static int transversal(const Piece *p, const Piece *q) {
    double one[2][SIDE], other[2][SIDE], size[2], sizes[2], off[2], offs[2], error = TINY;
    int side = 0;
    legs_of(p, one, size, off);
    legs_of(q, other, sizes, offs);
    for (int c = 0; c < 2; c++)
        error += size[c] * offs[1 - c] + off[c] * (sizes[1 - c] + offs[1 - c]) + 4 * ROUNDING * size[c] * sizes[1 - c];
    error *= 1 + 16 * ROUNDING;
    for (int i = 0; i < p->degree; i++)
        for (int j = 0; j < q->degree; j++) {
            double cross = one[0][i] * other[1][j] - one[1][i] * other[0][j];
            int own = cross > error ? 1 : cross < -error ? -1 : 0;
            if (!own || (side && own != side))
                return 0;
            side = own;
        }
    return 1;
}

/* Whether one piece certainly passes through the strip along the chord of the other from one side to the other. */
static int passes(const Piece *p, const Piece *q) {
    double chord[2], normal[2], strip[2], from[2], to[2];
    chord_of(q, chord, normal);
    values_of(normal, q, 0, q->degree, strip);
    values_of(normal, p, 0, 0, from);
    values_of(normal, p, p->degree, p->degree, to);
    return (from[1] < strip[0] && strip[1] < to[0]) || (to[1] < strip[0] && strip[1] < from[0]);
}

/* A point of a piece and the derivative there, without a proof. */
static void point_and_slope(const Piece *p, double t, double *point, double *slope) {
    double value[3], by[3], u = 1 - t;
    for (int c = 0; c < 3; c++) {
        double row[SIDE];
        memcpy(row, p->row[c], sizeof row);
        for (int level = p->degree; level > 1; level--)
            for (int i = 0; i < level; i++)
                row[i] = u * row[i] + t * row[i + 1];
        value[c] = u * row[0] + t * row[1];
        by[c] = p->degree * (row[1] - row[0]);
    }
    for (int c = 0; c < 2; c++) {
        point[c] = value[c] / value[2];
        slope[c] = (by[c] - point[c] * by[2]) / value[2];
    }
}

/* The parameters at which two transversal pieces nearly meet, by Newton's method: 0 where it leaves them far behind. */
static int nearly_met(const Piece *p, const Piece *q, double *at) {
    at[0] = at[1] = 0.5;
    for (int step = 0; step < NEWTON; step++) {
        double a[2], b[2], by[2], to[2];
        point_and_slope(p, at[0], a, by);
        point_and_slope(q, at[1], b, to);
        double x = b[0] - a[0], y = b[1] - a[1], det = by[0] * to[1] - by[1] * to[0];
        double one = (x * to[1] - y * to[0]) / det, other = (x * by[1] - y * by[0]) / det;
        at[0] += one;
        at[1] += other;
        if (!(fabs(at[0] - 0.5) < 1 && fabs(at[1] - 0.5) < 1))
            return 0;
        if (fmax(fabs(one), fabs(other)) < 0x1p-30)
            break;
    }
    return 1;
}

/* The common point of two transversal pieces, in intervals of both parameters: 1 if it is certain, -1 if it never will be,
   0 otherwise. */
static int enclosed(const Piece *p, const Piece *q, Search *own) {
    const Piece *given[2] = {p, q};
    double at[2], ends[2][2];
    Piece parts[2];
    if (!nearly_met(p, q, at))
        return 0;
    for (int k = 0; k < 2; k++) {
        double t = given[k]->low + given[k]->width * at[k];
        if (fabs(t) < AT_END || fabs(1 - t) < AT_END)
            return -1;
    }
    for (int h = 0; h < (int)(sizeof HALVES / sizeof *HALVES); h++) {
        int inside = 1;
        for (int k = 0; k < 2; k++) {
            double half = HALVES[h] / given[k]->width, spare = 2 * PLACED / given[k]->width;
            ends[k][0] = at[k] - half;
            ends[k][1] = at[k] + half;
            inside &= ends[k][0] > spare && ends[k][1] < 1 - spare;
        }
        if (!inside)
            return 0;
        for (int k = 0; k < 2; k++)
            inside &= part(given[k], ends[k][0], ends[k][1], parts + k);
        if (!inside || !passes(parts, parts + 1) || !passes(parts + 1, parts))
            continue;
        if (own->count == POINTS_OF_PAIR)
            return -1;
        double *here = own->found + OF_POINT * own->count++;
        for (int k = 0; k < 2; k++) {
            here[2 * k] = fmax(0, given[k]->low + given[k]->width * ends[k][0] - PLACED);
            here[2 * k + 1] = fmin(1, given[k]->low + given[k]->width * ends[k][1] + PLACED);
        }
        here[4] = 0;
        here[5] = -1;
        return 1;
    }
    return 0;
}

/* Find the common points of two pieces: 0 where they are not certain. */
static int searched(const Piece *p, const Piece *q, int level, Search *own) {
    Piece *left = own->pieces[level], *right = left + 1;
    if (separated(p, q))
        return 1;
    if (++own->compared > COMPARED)
        return 0;
    int known = transversal(p, q) ? enclosed(p, q, own) : 0;
    if (known)
        return known > 0;
    double size = fmax(p->most[0] - p->least[0], p->most[1] - p->least[1]);
    if (size >= fmax(q->most[0] - q->least[0], q->most[1] - q->least[1]))
        return halved(p, left, right) && searched(left, q, level + 1, own) && searched(right, q, level + 1, own);
    return halved(q, left, right) && searched(p, left, level + 1, own) && searched(p, right, level + 1, own);
}

/* Whether a piece, or one and the next, certainly runs on in one direction, so that it does not meet itself. */
static int runs_on(const Piece *p, const Piece *next) {
    const Piece *given[2] = {p, next};
    double legs[2][2][SIDE], size[2][2], off[2][2], direction[2], normal[2], more[2];
    chord_of(p, direction, normal);
    if (next) {
        chord_of(next, more, normal);
        direction[0] += more[0];
        direction[1] += more[1];
    }
    for (int k = 0; k < (next ? 2 : 1); k++) {
        double error = TINY;
        legs_of(given[k], legs[k], size[k], off[k]);
        for (int c = 0; c < 2; c++)
            error += fabs(direction[c]) * (off[k][c] + 4 * ROUNDING * size[k][c]) * (1 + 8 * ROUNDING);
        for (int i = 0; i < given[k]->degree; i++)
            if (!(direction[0] * legs[k][0][i] + direction[1] * legs[k][1][i] > error))
                return 0;
    }
    return 1;
}

/* Find the points that a piece and the next have in common beside the end of the first: 0 where they are not certain. */
static int next_to(const Piece *p, const Piece *next, int level, Search *own) {
    Piece *left = own->pieces[level], *right = own->pieces[level + 1];
    if (runs_on(p, next))
        return 1;
    return ++own->compared <= COMPARED && halved(p, left, left + 1) && halved(next, right, right + 1) &&
           searched(left, next, level + 2, own) && searched(left + 1, right + 1, level + 2, own) &&
           next_to(left + 1, right, level + 2, own);
}

/* Find the points through which a piece passes twice: 0 where they are not certain. */
static int met_itself(const Piece *p, int level, Search *own) {
    Piece *left = own->pieces[level], *right = left + 1;
    if (runs_on(p, NULL))
        return 1;
    return ++own->compared <= COMPARED && halved(p, left, right) && met_itself(left, level + 1, own) &&
           met_itself(right, level + 1, own) && next_to(left, right, level + 1, own);
}

/* Whether two segments may have an end in common, where no point is certain. */
static int ends_may_meet(const Piece *p, const Piece *q) {
    for (int i = 0; i <= p->degree; i += p->degree)
        for (int j = 0; j <= q->degree; j += q->degree) {
            int near = 1;
            for (int c = 0; c < 2; c++)
                near &= fabs(p->point[c][i] - q->point[c][j]) <= 2 * (p->off[c] + q->off[c]);
            if (near)
                return 1;
        }
    return 0;
}

/* The common points of two segments by their pieces; -1 where something is not certain. */
static int by_pieces(const double *one, const double *other, int itself, double *found) {
    Points p, q;
    Piece first, second;
    int known = 0;
    if (!brought_together(one, other, &p, &q) || !whole(&p, 1, &first) || !whole(&q, 4, &second) ||
        (!itself && ends_may_meet(&first, &second)))
        return -1;
    Search *own = malloc(sizeof *own);
    if (own) {
        own->compared = own->count = 0;
        own->found = found;
        known = itself ? met_itself(&first, 0, own) : searched(&first, &second, 0, own);
        known = known ? own->count : -1;
    }
    free(own);
    return own ? known : -1;
}

/* The common points of a segment of the first table and one of the second; without a second table of two segments of the
   first, and for a segment and itself the points through which it passes twice.

   first, second: for each segment, all of one degree, the degree (others than 1 to `HIGHEST` are left open), the ends of a
   box in x and in y, a point near the segment, and the coefficients of x, y and w in the scaled basis measured from this
   point, each rounded once.
   found: for every common point, of which there are at most `POINTS_OF_PAIR`, the ends of intervals of both parameters;
   that of the segment of higher degree (of the second, where they are alike) is a zero of the determinant: the sign before
   it, and its number among all zeros; 0 and -1 where the point was found without the determinant.

   Returns the number of common points, -1 where something is not certain. */
int filter_pair(const double *first, int i, const double *second, int j, double *found) {
    const double *table = second ? second : first;
    int size = numbers_of_each(first, ROWS, 1), other_size = numbers_of_each(table, ROWS, 1), known = -1;
    const double *one = first + i * size, *other = table + j * other_size;
    if (!size || !other_size)
        return -1;
    if (apart(one, other))
        return 0;
    if (one[0] <= ELIMINATED && other[0] <= ELIMINATED)
        known = by_determinant(one, other, !second && i == j, found);
    return known < 0 ? by_pieces(one, other, !second && i == j, found) : known;
}

/* ---- the parameters of a common point to twice the precision */

/* The coefficients of the coordinates x, y, w of a segment. */
typedef struct {
    int degree;
    Twice value[3][SIDE];
} Precise;

/* The numbers of the ends of a segment for `filter_closer`, which are its last; how often a step of Newton's method is
   taken. */
enum { OF_ENDS = 4, CLOSER = 6 };
/* Bounds of the roundings of an equation, and of those of its derivatives and of their inverse; the length of a step after
   which no other is needed, and how far from a point second derivatives are bounded. */
static const double OF_EQUATION = 0x1p-95, OF_DERIVATIVES = 0x1p-39, CLOSE = 0x1p-50, NEARBY = 0x1p-11;

/* A coordinate at a parameter, and its derivative in doubles. */
static Twice coordinate(const Precise *p, int c, double t, double *slope) {
    Twice u = sum_of(1, -t), v = {t, 0}, power = v, value = p->value[c][0];
    double raised = 1;
    *slope = 0;
    for (int i = 1; i <= p->degree; i++) {
        Twice next = p->value[c][i];
        *slope = *slope * u.high - value.high + next.high * raised;
        value = sum(product(value, u), product(next, power));
        raised = raised * t + power.high;
        power = product(power, v);
    }
    return value;
}

/* The values of x₂w₁ − x₁w₂ and y₂w₁ − y₁w₂ at two parameters, and their derivatives. */
static void equations(const Precise *p, const double *at, double *value, double (*by)[2]) {
    Twice own[2][3];
    double slope[2][3];
    for (int k = 0; k < 2; k++)
        for (int c = 0; c < 3; c++)
            own[k][c] = coordinate(p + k, c, at[k], &slope[k][c]);
    Twice w = own[0][2], minus = {-own[1][2].high, -own[1][2].low};
    for (int c = 0; c < 2; c++) {
        value[c] = sum(product(own[1][c], w), product(own[0][c], minus)).high;
        by[c][0] = own[1][c].high * slope[0][2] + slope[0][c] * minus.high;
        by[c][1] = slope[1][c] * w.high - own[0][c].high * slope[1][2];
    }
}

/* The largest size of a coefficient of a coordinate. */
static double size_of(const double *segment, int c) {
    int side = (int)segment[0] + 1;
    double size = 0;
    for (int i = 0; i < 2 * side; i++)
        size = fmax(size, fabs(segment[1 + 2 * c * side + i]));
    return size;
}

/* Both segments with no coefficient larger than 1, by powers of two that do not change the common points: 0 where they are
   too large or too small for that. */
static int made_alike(const double *const given[2], Precise *to) {
    static const double BIG = 0x1p300;
    double unit[2], far = 0;
    int e;
    for (int k = 0; k < 2; k++) {
        for (int i = 0; i < 1 + 6 * ((int)given[k][0] + 1); i++)
            if (!(fabs(given[k][i]) < BIG))
                return 0;
        double weight = size_of(given[k], 2);
        if (weight < 1)
            return 0;
        frexp(weight, &e);
        unit[k] = ldexp(1, -e);
        far = fmax(far, fmax(size_of(given[k], 0), size_of(given[k], 1)) * unit[k]);
    }
    if (far < 1 / BIG)
        return 0;
    frexp(far, &e);
    for (int k = 0; k < 2; k++) {
        to[k].degree = (int)given[k][0];
        for (int c = 0; c < 3; c++)
            for (int i = 0; i <= to[k].degree; i++) {
                const double *number = given[k] + 1 + 2 * (c * (to[k].degree + 1) + i);
                double scale = c < 2 ? ldexp(unit[k], -e) : unit[k];
                to[k].value[c][i] = (Twice){number[0] * scale, number[1] * scale};
            }
    }
    return 1;
}

/* The parameters of a common point of a segment of the first table and one of the second.

   first, second: for each segment, all of one degree, the degree, and the coefficients of x, y and w in the scaled basis,
   integers, each as a double near it and the difference from it, rounded once; doubles near the ends of the segment, and the
   differences from these.
   box: the ends of the intervals of both parameters, in which there is one common point. They are replaced: for each
   parameter a double near it, the difference from it, a bound of the error of the difference, and the double nearest to the
   parameter on the curve; not a number where that is not certain.

   Returns 1 if it is proved again that there is a common point in the box, and where it is; 0 otherwise. */
int filter_closer(const double *first, int i, const double *second, int j, double *box) {
    int size = numbers_of_each(first, 1 + OF_ENDS, 2), other_size = numbers_of_each(second, 1 + OF_ENDS, 2);
    const double *given[2] = {first + i * size, second + j * other_size};
    double at[2] = {(box[0] + box[1]) / 2, (box[2] + box[3]) / 2}, value[2], by[2][2], move[2], norm, all;
    Precise p[2];
    if (!size || !other_size || !to_nearest() || !made_alike(given, p))
        return 0;
    double degree = fmax(p[0].degree, p[1].degree);
    for (int step = 1;; step++) {
        equations(p, at, value, by);
        double det = by[0][0] * by[1][1] - by[0][1] * by[1][0];
        double inverse[2][2] = {{by[1][1] / det, -by[0][1] / det}, {-by[1][0] / det, by[0][0] / det}};
        norm = all = 0;
        for (int k = 0; k < 2; k++) {
            double one = inverse[k][0] * value[0], other = inverse[k][1] * value[1];
            move[k] = -(one + other);
            all = fmax(all, fabs(one) + fabs(other));
            norm = fmax(norm, fabs(inverse[k][0]) + fabs(inverse[k][1]));
        }
        if (step == CLOSER || fmax(fabs(move[0]), fabs(move[1])) < CLOSE)
            break;
        for (int k = 0; k < 2; k++)
            at[k] = fmax(box[2 * k], fmin(box[2 * k + 1], at[k] + move[k]));
    }
    double around = 4 * (all + norm * OF_EQUATION), contraction = norm * (32 * degree * degree * around + OF_DERIVATIVES);
    double error = 2 * SLACK * (contraction * all + norm * OF_EQUATION + 4 * ROUNDING * all);
    int inside = contraction < 0.25 && around < NEARBY;
    for (int k = 0; k < 2; k++)
        inside &= fmin((at[k] - box[2 * k]) + move[k], (box[2 * k + 1] - at[k]) - move[k]) > 2 * error + CLOSE * CLOSE;
    for (int k = 0; k < 2 && inside; k++) {
        const double *ends = given[k] + (k ? other_size : size) - OF_ENDS;
        double known[4] = {at[k], move[k], error, nearest_over(ends, ends + 2, (Near){sum_of(at[k], move[k]), error})};
        memcpy(box + 4 * k, known, sizeof known);
    }
    return inside;
}

/* ---- points of a curve, in exact integers */

/* The numbers before all others: the degree; how many components, limbs of a number, control points and segments there
   are; whether limits are from the left; and how many places there are. */
enum { DEGREE, COMPONENTS, LIMBS, POINTS, SEGMENTS, LEFT, PLACES, SIZES };
/* In `curve_forms` two of them are others. */
enum { RATIONAL = LEFT, TOTAL = PLACES };

#ifdef __SIZEOF_INT128__
__extension__ typedef unsigned __int128 Wide;

/* Add a multiple of a number, modulo 2 to the power 64 · limbs, which is right in two's complement, too. */
static void add_multiple(uint64_t *to, const uint64_t *number, uint64_t by, int64_t limbs) {
    Wide carry = 0;
    for (int64_t k = 0; k < limbs; k++) {
        carry += (Wide)number[k] * by + to[k];
        to[k] = (uint64_t)carry;
        carry >>= 64;
    }
}

/* Replace a number by its multiple. */
static void multiply(uint64_t *number, uint64_t by, int64_t limbs) {
    Wide carry = 0;
    for (int64_t k = 0; k < limbs; k++) {
        carry += (Wide)number[k] * by;
        number[k] = (uint64_t)carry;
        carry >>= 64;
    }
}

/* A coefficient of a component of a curve on a segment: a sum of multiples of the control points. */
static void coefficient(const int64_t *sizes, const uint64_t *weights, const uint64_t *points, int64_t c, int64_t segment,
                        int64_t i, uint64_t *to) {
    const int64_t n = sizes[DEGREE], limbs = sizes[LIMBS], *firsts = sizes + SIZES;
    memset(to, 0, (size_t)limbs * sizeof(uint64_t));
    for (int64_t j = 0; j <= n; j++) {
        uint64_t weight = weights[(segment * (n + 1) + i) * (n + 1) + j];
        if (weight)
            add_multiple(to, points + (c * sizes[POINTS] + firsts[segment] + j) * limbs, weight, limbs);
    }
}

/* Change the sign of a number, or leave it. */
static void negated(uint64_t *number, int64_t limbs, int changed) {
    uint64_t carry = 1;
    for (int64_t k = 0; changed && k < limbs; k++) {
        number[k] = ~number[k] + carry;
        carry &= number[k] == 0;
    }
}

/* The number of bits of a number ≥ 0. */
static int64_t bits_of(const uint64_t *number, int64_t limbs) {
    while (limbs && !number[limbs - 1])
        limbs--;
    int64_t bits = 64 * limbs;
    for (uint64_t top = limbs ? number[limbs - 1] : 0; top && !(top >> 63); top <<= 1)
        bits--;
    return bits;
}

/* The first 53 bits of a number ≥ 0, divided by a power of two, in every rounding mode; they are taken away from it. */
static double first_of(uint64_t *number, int64_t limbs, int64_t power) {
    int64_t bits = bits_of(number, limbs), low = bits > 53 ? bits - 53 : 0, at = low / 64, by = low % 64;
    uint64_t first = number[at] >> by;
    number[at] &= ((uint64_t)1 << by) - 1;
    if (by && at + 1 < limbs) {
        first |= number[at + 1] << (64 - by);
        number[at + 1] = 0;
    }
    return ldexp((double)(int64_t)first, (int)(low - power));
}

/* The segment of a place: at a breakpoint the one on its right, or on its left. */
static int64_t segment_of(const int64_t *breaks, int64_t segments, int64_t place, int64_t left) {
    int64_t low = 0, high = segments;
    while (high - low > 1) {
        int64_t middle = (low + high) / 2;
        if (breaks[middle] < place || (breaks[middle] == place && !left))
            low = middle;
        else
            high = middle;
    }
    return low;
}

/* The first 64 bits of the size of a number: it is from head · 2^e to (head + 1) · 2^e, ends included. Returns 0 for the
   number 0. */
static int beginning(const uint64_t *number, int64_t limbs, uint64_t *head, int64_t *e, int *negative) {
    int64_t k = limbs - 1;
    *negative = number[k] >> 63 != 0;
    /* the complement of a negative number is its size minus 1, which matters if it has fewer bits than the head */
    uint64_t flipped = *negative ? UINT64_MAX : 0;
    while (k > 0 && number[k] == flipped)
        k--;
    int shift = 0;
    *head = number[k] ^ flipped;
    *head += *negative && k == 0 && *head != UINT64_MAX;
    if (!*head)
        return 0;
    while (!(*head >> 63)) {
        *head <<= 1;
        shift++;
    }
    if (shift && k)
        *head |= (number[k - 1] ^ flipped) >> (64 - shift);
    *e = 64 * k - shift;
    return 1;
}

/* The double nearest to a quotient; NaN if it is not certain. It is the same in every rounding mode. */
static double nearest_quotient(const uint64_t *top, const uint64_t *bottom, int64_t limbs) {
    uint64_t a, b;
    int64_t e, f;
    int minus, below;
    if (!beginning(top, limbs, &a, &e, &minus))
        return 0;
    if (!beginning(bottom, limbs, &b, &f, &below))
        return NAN;
    /* the quotient divided by 2^(e - f - 63) is more than q - 2, at most q + 2, and q has 63 or 64 bits */
    uint64_t q = (uint64_t)(((Wide)a << 63) / b);
    int dropped = q >> 63 ? 11 : 10;
    uint64_t half = (uint64_t)1 << (dropped - 1), rest = q & (2 * half - 1), kept = q >> dropped;
    e += dropped - 63 - f;
    if ((rest + 2 >= half && rest <= half + 2) || e < -1000 || e > 900)
        return NAN;
    double size = ldexp((double)(int64_t)(kept + (rest > half)), (int)e);
    return minus == below ? size : -size;
}
#endif

/* The numerators of each coordinate of the points of a curve at places, and then their denominators; and the doubles
   nearest to the quotients.

   sizes: the `SIZES` numbers above, the first control point of each segment, the breakpoints, and the places, which are in
   the domain.
   weights: for each segment, coefficient (in the scaled Bernstein basis) and control point of the segment an integer ≥ 0.
   points: the numerators of each coordinate of the control points, and their denominators, in two's complement.
   found: room for the integers, and for the coefficients of one segment and one more number.
   near: room for the doubles, NaN where they are not certain; NULL if they are not needed.

   Returns 1, or 0 where the compiler has no integers of 128 bits. The caller knows that the results have enough limbs. */
int curve_points(const int64_t *sizes, const uint64_t *weights, const uint64_t *points, uint64_t *found, double *near) {
#ifdef __SIZEOF_INT128__
    const int64_t n = sizes[DEGREE], components = sizes[COMPONENTS], limbs = sizes[LIMBS], count = sizes[PLACES];
    const int64_t *breaks = sizes + SIZES + sizes[SEGMENTS], *places = breaks + sizes[SEGMENTS] + 1;
    const size_t size = (size_t)limbs * sizeof(uint64_t);
    uint64_t *rows = found + components * count * limbs, *term = rows + components * (n + 1) * limbs;
    int64_t here = -1;
    for (int64_t k = 0; k < count; k++) {
        int64_t segment = segment_of(breaks, sizes[SEGMENTS], places[k], sizes[LEFT]);
        if (segment != here) {
            here = segment;
            for (int64_t c = 0; c < components; c++)
                for (int64_t i = 0; i <= n; i++)
                    coefficient(sizes, weights, points, c, segment, i, rows + (c * (n + 1) + i) * limbs);
        }
        uint64_t u = (uint64_t)(breaks[segment + 1] - places[k]), v = (uint64_t)(places[k] - breaks[segment]);
        for (int64_t c = 0; c < components; c++) {
            uint64_t *value = found + (c * count + k) * limbs;
            memcpy(value, rows + (c * (n + 1) + n) * limbs, size);
            /* Horner's rule: the coefficient of uⁿ⁻ⁱ vⁱ is multiplied by uⁿ⁻ⁱ and added */
            for (int64_t i = n - 1; i >= 0; i--) {
                multiply(value, v, limbs);
                memcpy(term, rows + (c * (n + 1) + i) * limbs, size);
                for (int64_t power = i; power < n - 1; power++)
                    multiply(term, u, limbs);
                add_multiple(value, term, u, limbs);
            }
        }
    }
    const uint64_t *below = found + (components - 1) * count * limbs;
    for (int64_t k = 0; near && k < (components - 1) * count; k++)
        near[k] = nearest_quotient(found + k * limbs, below + k % count * limbs, limbs);
    return 1;
#else
    (void)sizes, (void)weights, (void)points, (void)found, (void)near;
    return 0;
#endif
}

#ifdef __SIZEOF_INT128__
/* Add a product of two numbers, or subtract it. */
static void add_product_of(uint64_t *to, const uint64_t *a, const uint64_t *b, int64_t limbs, int minus) {
    negated(to, limbs, minus);
    for (int64_t k = 0; k < limbs; k++)
        add_multiple(to + k, a, b[k], limbs - k);
    negated(to, limbs, minus);
}

/* `curve_forms` with room for the forms of a segment, the weight function of a polynomial curve, and a number. */
static void written(const int64_t *sizes, const uint64_t *weights, const uint64_t *points, double *near, double *rest,
                    uint64_t *room) {
    const int64_t n = sizes[DEGREE], components = sizes[COMPONENTS], limbs = sizes[LIMBS], width = (n + 1) * limbs;
    const int64_t coordinates = components - (sizes[RATIONAL] != 0), start = sizes[SIZES + sizes[SEGMENTS]];
    const uint64_t *below = points + components * sizes[POINTS] * limbs;
    uint64_t *w = room + coordinates * width, *number = room + (coordinates + 1) * width;
    double binomial[MOST];
    binomials(binomial, (int)n);
    memset(w, 0, (size_t)width * sizeof(uint64_t));
    for (int64_t i = 0; i <= n; i++)
        w[i * limbs] = (uint64_t)binomial[i];
    for (int64_t segment = 0; segment < sizes[SEGMENTS]; segment++) {
        for (int64_t c = 0; c < components; c++)
            for (int64_t i = 0; i <= n; i++)
                coefficient(sizes, weights, points, c, segment, i, room + c * width + i * limbs);
        /* the denominator first, by the size of which all are divided */
        int64_t power = 0;
        for (int64_t c = components; c >= 0; c--)
            for (int64_t i = 0; i <= (c < components ? n : 0); i++) {
                int64_t to = c * sizes[TOTAL] * (n + 1) + (start + segment) * (c < components ? n + 1 : 1) + i;
                memset(number, 0, (size_t)limbs * sizeof(uint64_t));
                add_product_of(number, c < components ? room + c * width + i * limbs : below + segment * limbs, w, limbs, 0);
                if (c < coordinates)
                    add_product_of(number, room + c * width, w + i * limbs, limbs, 1);
                int negative = number[limbs - 1] >> 63 != 0;
                negated(number, limbs, negative);
                power = c < components ? power : bits_of(number, limbs) - 1;
                near[to] = first_of(number, limbs, power) * (negative ? -1 : 1);
                rest[to] = first_of(number, limbs, power) * (negative ? -1 : 1);
            }
    }
}
#endif

/* The coefficients of a curve on its segments, each of which is moved so that it begins at the origin, as doubles near
   integers: of a coordinate x with the weight function w, those of w₀ x − x₀ w, which is w₀ w times the distance.

   sizes: the first numbers as in `curve_points`, but whether the last component is the weight function instead of LEFT,
   and of how many segments there is room in the results instead of the number of places; then the first control point of
   each segment; and the place of the first segment in the results.
   weights: as in `curve_points`.
   points: the numbers of each component of the control points, and the denominators of the segments, in two's complement.
   near: for each component, segment and coefficient the double with the first 53 bits of the integer, that of w₀ w for the
   weight function, and then for each segment that of w₀ times its denominator. Without weights w is 1. On each segment all
   are divided by the same power of two, such that the size of the last is from 1 to 2.
   rest: the same of the differences from the integers.

   Returns 1, or 0 where the compiler has no integers of 128 bits, the degree is too high, or there is no memory. The caller
   knows that the results have enough limbs. */
int curve_forms(const int64_t *sizes, const uint64_t *weights, const uint64_t *points, double *near, double *rest) {
#ifdef __SIZEOF_INT128__
    int64_t numbers = (sizes[COMPONENTS] + 1) * (sizes[DEGREE] + 1) + 1;
    uint64_t *room = sizes[DEGREE] < MOST ? malloc((size_t)(numbers * sizes[LIMBS]) * sizeof *room) : NULL;
    if (room)
        written(sizes, weights, points, near, rest, room);
    free(room);
    return room != NULL;
#else
    (void)sizes, (void)weights, (void)points, (void)near, (void)rest;
    return 0;
#endif
}
