; The tests of one pass: induction step over the hypotheses tested
; Says: A test walks a simple path in S, at most s-1 steps, and back: so after h tests at most
;   2(s-1)h. Step: with one test more.
; Paper: VI ('Each path traversal is bounded by 2(n_s - 1)')
; Symbols:
;   s                   vertices known
;   tests               tests made so far in this pass
;   cost, cost_after    edge traversals of the tests so far, and with one more
;   steps               steps of its path
; Expected: unsat

(set-logic QF_NRA)
(declare-const s Real)
(declare-const tests Real)
(declare-const cost Real)
(declare-const steps Real)
(declare-const cost_after Real)

; a simple path, there and back
(assert (<= steps (- s 1.0)))
(assert (= cost_after (+ cost (* 2.0 steps))))
; induction hypothesis
(assert (<= cost (* 2.0 (- s 1.0) tests)))

; not: the same with one test more
(assert (not (<= cost_after (* 2.0 (- s 1.0) (+ tests 1.0)))))
(check-sat)
