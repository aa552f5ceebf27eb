// The task language. docs/language.md explains it; this file says exactly what is well-formed.
//
// Between the lexer and the parser (compiler/syntax/layout.h)
//   - LINE_END is put where a line ends a statement: not inside ( ) [ ], not after an operator or a
//     comma, not before `{`, `else`, `in`, `per` or `->`;
//   - braces inside ( ) or [ ], in the set of a `for` and in a `set` become SET_BEGIN and SET_END:
//     `{body, head}` is no block;
//   - words that are keywords only where a statement or declaration begins (FN ... RETURN below)
//     become NAME elsewhere, and so do WITHIN where it does not stand between two operands and
//     ANY_UNIT where it is not in the brackets of a type: nothing is lost as a name;
//   - brackets are checked and, where they are wrong, repaired: one mistake gives one message.
// The names of events, reductions, scopes and outcomes are ordinary words here, listed in
// compiler/syntax/words.h: a misspelled one gets a message of its own, and none is lost as a name.
// Precedence, from loose to tight: or, and, not, comparison, sum, product, minus, postfix.
grammar Task;

tokens { LINE_END, SET_BEGIN, SET_END }

// ---- Declarations -------------------------------------------------------------------------------

// The tree builder checks the order: a task has its header first, a library has none, and no
// declarations but imports, functions, sets, tables and consts.
file : (allow | header | declaration)* EOF ;

// task crawling for humanoid, task backward_rolling extends "forward_rolling.task",
// task kick for humanoid in "ball.toml"
header : TASK name (EXTENDS base=STRING)? (FOR robot=name)? (IN world=STRING)? LINE_END? ;

declaration
    : ( start | afterEnd | sensor | param | memory | goal | observation | metric | reward | constant
      | namedSet | table | event | phase | function | imported | test | change ) LINE_END?
    ;

// allow W0706, W0712: above a declaration, a statement or the header
allow : ALLOW NAME (',' NAME)* (LINE_END | EOF) ;

// start standing, start standing or lying { joint.angle += uniform(-0.1 rad, 0.1 rad) }
start : START name (OR name)* block? ;

// after_end continue
afterEnd : AFTER_END behavior=NAME ;

// sensor pole.angle: real [rad] in -180 deg .. 180 deg
sensor : SENSOR name ('.' name)* ':' type range? ;

// param gain: real [1/s] = 4 / s in 0 .. 20 / s
param : PARAM name ':' type '=' expression range? ;

// memory fallen: bool = false per action
memory : MEMORY name ':' type '=' expression (PER scope=NAME)? ;

// goal side: int = choose(0, 1), goal velocity: vec2 [m/s] = uniform(-1 m/s, 1 m/s) per 3 s .. 8 s
goal : GOAL name ':' type '=' value=expression (PER shortest=expression ('..' longest=expression)?)? ;

// observe base.up, observe clock = sin(angle), observe onboard
observation : OBSERVE (name ('.' name)* '=')? expression ;

// metric max height = base.position.z
metric : METRIC reduction=word? name '=' expression ;

// const reach: real [m] = 5 cm
constant : CONST name ':' type '=' expression ;

// set supports = {feet, hands}
namedSet : SET name '=' items ;

// table gait: real[joint] [rad] = "walk.csv"
table : TABLE name ':' type '=' STRING ;

// on end_of_time_step { ... }
event : ON name block ;

// phase lift within 3 s else reach { ... }
phase : PHASE name limit? block ;

limit : WITHIN time=expression ELSE otherwise=name ;

// import "shaping.task"
imported : IMPORT STRING ;

range : IN minimum=expression '..' maximum=expression ;

// ---- Functions ----------------------------------------------------------------------------------

// fn near(distance: real [m], reach: real [m]) -> real = exp(-distance / reach)
function : FN name '(' (parameter (',' parameter)*)? ')' '->' type ('=' expression | body) ;

parameter : name ':' type ;

// { let x = ... return x }: the tree builder checks that one `return` ends it.
body : '{' bodyStatement* '}' ;

bodyStatement : ( let | RETURN expression ) LINE_END? ;

// ---- What a task changes of the one that it extends ---------------------------------------------

change
    : OVERRIDE
      ( start | afterEnd | newDefault | newConstant | namedSet | newTable | newGoal | newObservation
      | metric | reward | event | phase | function )
    ;

// override param direction = -1
newDefault : PARAM name '=' expression range? ;

// override const reach = 10 cm
newConstant : CONST name '=' expression ;

// override table gait = "run.csv"
newTable : TABLE name '=' STRING ;

// override goal velocity = uniform(0 m/s, 2 m/s)
newGoal : GOAL name '=' value=expression (PER shortest=expression ('..' longest=expression)?)? ;

// override observe clock = cos(angle), override observe base.up = base.forward
newObservation : OBSERVE name ('.' name)* '=' expression ;

// ---- Tests --------------------------------------------------------------------------------------

// test "a fall is paid once" { ... }
test : TEST STRING testBlock ;

testBlock : '{' (allow | testStatement)* '}' ;

testStatement : ( given | fire | expect ) LINE_END? ;

// given contact[head] = true
given : GIVEN target '=' expression ;

// fire start_of_action, 100 * end_of_time_step
fire : FIRE fired (',' fired)* ;

fired : (times=NUMBER '*')? name ;

// expect total(fall) == -4, expect end_episode failure "fell"
expect : EXPECT ( end | expression ) ;

// ---- Types --------------------------------------------------------------------------------------

// real, vec3 [m/s], bool[link], real[4]
type : name ('[' (index=name | length=NUMBER) ']')? ('[' unit ']')? ;

// ---- Statements ---------------------------------------------------------------------------------

block : '{' (allow | statement)* '}' ;

statement
    : ( let | assignment | branches | loop | once | reward | end | log | require | redraw
      | transition ) LINE_END?
    ;

// let speed = norm(base.velocity)
let : LET name '=' expression ;

// sum += reward, touched[feet] = false
assignment : (target | anonymous=REWARD) op=('=' | '+=' | '-=' | '*=' | '/=') expression ;

// place.xy, touched[feet], last[left_foot].z; in a test also a sensor with its dots
target : path+=name ('.' path+=name)* ('[' items ']' ('.' element=name)?)? ;

// if time > 20 s { ... } else if fallen { ... } else { ... }
branches : IF expression block (ELSE IF expression block)* (ELSE otherwise=block)? ;

// for l in links - feet { ... }, for i in 0..3 { ... }
loop : FOR name IN items block ;

// once per action if fallen { ... } else if rolled { ... }; the tree builder rejects `otherwise`.
once
    : ONCE PER scope=NAME IF expression block (ELSE IF expression block)* (ELSE otherwise=block)?
    ;

// reward fall = -4, reward rate forward = base.velocity.x; outside of blocks only
// reward potential near = -norm(base.position), which the tree builder checks
reward : REWARD kind=NAME? name '=' expression ;

// end_episode failure "fell", truncate_episode "time is up"
end : END_EPISODE outcome=NAME STRING | TRUNCATE_EPISODE STRING ;

// log max speed = norm(base.velocity)
log : LOG reduction=word? name '=' expression ;

// require norm(base.position) < 100 m "stays near"
require : REQUIRE expression STRING? ;

// redraw velocity
redraw : REDRAW name ;

// next lift
transition : NEXT name ;

// ---- Expressions --------------------------------------------------------------------------------

expression : conjunction (OR conjunction)* ;

conjunction : negation (AND negation)* ;

negation : NOT negation | comparison ;

// Not chained: `a < b < c` is no expression. The checker says where `within` may stand.
comparison : sum (op=('<' | '<=' | '>' | '>=' | '==' | '!=') sum (WITHIN tolerance=sum)?)? ;

sum : product (('+' | '-') product)* ;

product : factor (('*' | '/') factor)* ;

factor : '-' factor | postfix ;

// With `arguments` it is never well-formed, which the checker says: it knows what was meant.
postfix : primary (member arguments? | selection)* ;

// base.position, .xy
member : '.' name ;

// [body, head], [2..7, links - feet]
selection : '[' items ']' ;

items : item (',' item)* ;

item : expression ('..' expression)? ;

primary
    : number
    | TRUE
    | FALSE
    | call
    | NAME
    | REWARD
    | '(' expression ')'
    | SET_BEGIN items SET_END    // only in an index set, which the tree builder checks
    ;

call : callee=word arguments ;

arguments : '(' (expression (',' expression)*)? ')' ;

// ---- Numbers and units --------------------------------------------------------------------------

// 20 s, 0.5 m/s, 4 / s. A name is never a unit nor a unit a name, so it is clear where the unit
// ends: in 0.25 / 5 ms * dot(a, b) it is ms.
number : NUMBER literalUnit? ;

literalUnit : (unitFactor | unitOperator unitFactor) (unitOperator unitFactor)* ;

// In brackets the factors may also stand side by side: [N m]. The tree builder lets ANY_UNIT stand
// only in functions.
unit : (one=NUMBER unitOperator)? unitFactor (unitOperator? unitFactor)* ;

unitOperator : '*' | '/' ;

unitFactor : (unitName | ANY_UNIT) ('^' minus='-'? power=NUMBER)? ;

// What they stand for: compiler/check/unit.cpp.
unitName
    : 'm' | 'cm' | 'mm' | 'km' | 's' | 'ms' | 'us' | 'min' | 'kg' | 'g' | 'N' | 'J' | 'W' | 'Hz'
    | 'rad' | 'deg'
    ;

// ---- Words --------------------------------------------------------------------------------------

name : NAME ;

// `min` is a unit, a function and a reduction; its place says which.
word : NAME | MIN ;

TASK : 'task' ;
FOR : 'for' ;
START : 'start' ;
SENSOR : 'sensor' ;
PARAM : 'param' ;
MEMORY : 'memory' ;
METRIC : 'metric' ;
ON : 'on' ;
IN : 'in' ;
PER : 'per' ;
LET : 'let' ;
IF : 'if' ;
ELSE : 'else' ;
REWARD : 'reward' ;
END_EPISODE : 'end_episode' ;
TRUNCATE_EPISODE : 'truncate_episode' ;
OR : 'or' ;
AND : 'and' ;
NOT : 'not' ;
TRUE : 'true' ;
FALSE : 'false' ;

// Names, but where a statement or declaration begins.
FN : 'fn' ;
IMPORT : 'import' ;
EXTENDS : 'extends' ;
OVERRIDE : 'override' ;
ALLOW : 'allow' ;
AFTER_END : 'after_end' ;
TEST : 'test' ;
GIVEN : 'given' ;
FIRE : 'fire' ;
EXPECT : 'expect' ;
ONCE : 'once' ;
SET : 'set' ;
CONST : 'const' ;
TABLE : 'table' ;
LOG : 'log' ;
REQUIRE : 'require' ;
GOAL : 'goal' ;
REDRAW : 'redraw' ;
OBSERVE : 'observe' ;
PHASE : 'phase' ;
NEXT : 'next' ;
RETURN : 'return' ;

// A name, but between two operands.
WITHIN : 'within' ;

// A name, but in the brackets of a type: `real [unit]`.
ANY_UNIT : 'unit' ;

MIN : 'min' ;

NAME : [a-zA-Z_] [a-zA-Z_0-9]* ;

NUMBER : DIGITS ('.' DIGITS)? ([eE] [+-]? DIGITS)? ;

STRING : '"' (~["\\\r\n] | '\\' ~[\r\n])* '"' ;

// ---- Signs --------------------------------------------------------------------------------------

ASSIGN : '=' ;
ADD_ASSIGN : '+=' ;
SUBTRACT_ASSIGN : '-=' ;
MULTIPLY_ASSIGN : '*=' ;
DIVIDE_ASSIGN : '/=' ;
LESS : '<' ;
LESS_EQUAL : '<=' ;
GREATER : '>' ;
GREATER_EQUAL : '>=' ;
EQUAL : '==' ;
NOT_EQUAL : '!=' ;
PLUS : '+' ;
MINUS : '-' ;
TIMES : '*' ;
DIVIDE : '/' ;
POWER : '^' ;
ARROW : '->' ;
COLON : ':' ;
COMMA : ',' ;
DOT : '.' ;
RANGE : '..' ;
LEFT_PARENTHESIS : '(' ;
RIGHT_PARENTHESIS : ')' ;
LEFT_BRACKET : '[' ;
RIGHT_BRACKET : ']' ;
LEFT_BRACE : '{' ;
RIGHT_BRACE : '}' ;

// ---- Between the words --------------------------------------------------------------------------

DOC_COMMENT : '///' ~[\r\n]* -> channel(HIDDEN) ;
COMMENT : '//' ~[\r\n]* -> skip ;
BLANK : [ \t\r\n\f]+ -> skip ;

// ---- Never well-formed, but named so that the message can say what is wrong ---------------------

UNCLOSED_STRING : '"' (~["\\\r\n] | '\\' ~[\r\n])* '\\'? ;
NUMBER_WITHOUT_ZERO : '.' DIGITS ([eE] [+-]? DIGITS)? ;
FOREIGN
    : '&&' | '||' | '!' | '&' | '|' | '~' | '<>' | '~=' | '===' | '!==' | '=<' | '=>' | ':='
    | '.*' | './' | '.^' | '**' | '++' | '@' | '%' | '?' | ';'
    ;
FOREIGN_COMMENT : '#' ~[\r\n]* ;
FOREIGN_STRING : '\'' ~['\r\n]* '\'' ;
BLOCK_COMMENT : '/*' .*? ('*/' | EOF) ;
// The lexer reads bytes: a run of them is a run of characters beyond ASCII.
BEYOND_ASCII : [\u0080-\u00FF]+ ;
UNKNOWN : . ;

fragment DIGITS : [0-9]+ ;
