/* model.h: the generated model under names that do not depend on the robot.
 * The compiler is told -DMODEL=ella -DMODEL_UPPER=ELLA -DMODEL_HEADER="ella_reference.h".
 */
#ifndef MODEL_H
#define MODEL_H

#include MODEL_HEADER

#define JOIN2(a, b) a##b
#define JOIN(a, b) JOIN2(a, b)
#define M(name) JOIN(MODEL, JOIN(_, name))       /* M(state) is ella_state */
#define N(name) JOIN(MODEL_UPPER, JOIN(_, name)) /* N(NQ) is ELLA_NQ */

typedef M(real) real;

#endif
