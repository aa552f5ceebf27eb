// The task language. docs/language.md explains it; this file says exactly what is well-formed.
//
// Between the lexer and the parser (compiler/syntax/layout.h)
//   - LINE_END is put where a line ends a statement: not inside ( ) [ ], not after an operator or a
//     comma, not before `{`, `else`, `in` or `per`;
//   - braces inside ( ) or [ ] become SET_BEGIN and SET_END: `{body, head}` is no block;
//   - brackets are checked and, where they are wrong, repaired: one mistake gives one message.
// The names of events, reductions, scopes and outcomes are ordinary words here, listed in
// compiler/syntax/words.h: a misspelt one gets a message of its own, and none is lost as a name.
// Precedence, from loose to tight: or, and, not, comparison, sum, product, minus, postfix.
grammar Task;

tokens { LINE_END, SET_BEGIN, SET_END }

// ---- Declarations -------------------------------------------------------------------------------

file : header declaration* EOF ;

// task crawling for humanoid
header : TASK name (FOR robot=name)? LINE_END? ;

declaration : ( start | sensor | param | memory | metric | event ) LINE_END? ;

// start standing
start : START name ;

// sensor base.velocity: vec3 [m/s]
sensor : SENSOR name ('.' name)* ':' type ;

// param gain: real [1/s] = 4 / s in 0 .. 20 / s
param
    : PARAM name ':' type '=' initial=expression (IN minimum=expression '..' maximum=expression)?
    ;

// memory fallen: bool = false per action
memory : MEMORY name ':' type '=' expression (PER scope=NAME)? ;

// metric max height = base.position.z
metric : METRIC reduction=word? name '=' expression ;

// on end_of_time_step { ... }
event : ON name block ;

// real, vec3 [m/s], bool[link], real[4]
type : name ('[' (index=name | length=NUMBER) ']')? ('[' unit ']')? ;

// ---- Statements ---------------------------------------------------------------------------------

block : '{' statement* '}' ;

statement : ( let | assignment | branches | reward | end ) LINE_END? ;

// let speed = norm(base.velocity)
let : LET name '=' expression ;

// sum += reward
assignment : target=(NAME | REWARD) op=('=' | '+=' | '-=' | '*=' | '/=') expression ;

// if time > 20 s { ... } else if fallen { ... } else { ... }
branches : IF expression block (ELSE IF expression block)* (ELSE otherwise=block)? ;

// reward fall = -4, reward rate forward = base.velocity.x
reward : REWARD rate=NAME? name '=' expression ;

// end_episode failure "fell", truncate_episode "time is up"
end : END_EPISODE outcome=NAME STRING | TRUNCATE_EPISODE STRING ;

// ---- Expressions --------------------------------------------------------------------------------

expression : conjunction (OR conjunction)* ;

conjunction : negation (AND negation)* ;

negation : NOT negation | comparison ;

// Not chained: `a < b < c` is no expression.
comparison : sum (op=('<' | '<=' | '>' | '>=' | '==' | '!=') sum)? ;

sum : product (('+' | '-') product)* ;

product : factor (('*' | '/') factor)* ;

factor : '-' factor | postfix ;

postfix : primary (member | selection)* ;

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
    | SET_BEGIN items SET_END    // only inside an index, which the tree builder checks
    ;

call : function=word '(' (expression (',' expression)*)? ')' ;

// ---- Numbers and units --------------------------------------------------------------------------

// 20 s, 0.5 m/s, 4 / s. A name is never a unit nor a unit a name, so it is clear where the unit
// ends: in 0.25 / 5 ms * dot(a, b) it is ms.
number : NUMBER literalUnit? ;

literalUnit : (unitFactor | unitOperator unitFactor) (unitOperator unitFactor)* ;

// In brackets the factors may also stand side by side: [N m].
unit : (one=NUMBER unitOperator)? unitFactor (unitOperator? unitFactor)* ;

unitOperator : '*' | '/' ;

unitFactor : unitName ('^' minus='-'? power=NUMBER)? ;

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
FOREIGN : '&&' | '||' | '!' | ';' | '%' | '**' | '++' | '<>' | '#' ;
FOREIGN_STRING : '\'' ~['\r\n]* '\'' ;
BLOCK_COMMENT : '/*' .*? ('*/' | EOF) ;
// The lexer reads bytes: a run of them is a run of characters beyond ASCII.
BEYOND_ASCII : [\u0080-\u00FF]+ ;
UNKNOWN : . ;

fragment DIGITS : [0-9]+ ;
