; The bound of one pass
; Says: At most s traversals to the unknown end of e, and at most 2(s-1) for each of the
;   hypotheses, of which there are at most as many as unexplored darts, 2m-2p: together s +
;   2(s-1)(2m-2p).
; Paper: VI ('Each loop begins with ... at most n_s edge traversals')
; Symbols:
;   m              edges of the world
;   p, s           edges explored before the pass, vertices known
;   tests          hypotheses tested
;   way            traversals to v_k and along e
;   cost_tests     traversals of all tests of the pass;  cost: of the pass
;   pass_bound     s + 2(s-1)(2m-2p)
; Expected: unsat

(set-logic QF_NRA)
(declare-const m Real)
(declare-const p Real)
(declare-const s Real)
(declare-const tests Real)
(declare-const way Real)
(declare-const cost_tests Real)
(declare-const cost Real)
(define-fun pass_bound ((s Real) (p Real)) Real (+ s (* 2.0 (- s 1.0) (- (* 2.0 m) (* 2.0 p)))))

; v0 is known
(assert (<= 1.0 s))
; the way to e, and e
(assert (<= way s))
; a hypothesis is an unexplored dart
(assert (<= tests (- (* 2.0 m) (* 2.0 p))))
; bound-tests-step, to its end
(assert (<= cost_tests (* 2.0 (- s 1.0) tests)))
(assert (= cost (+ way cost_tests)))

; not: within the bound
(assert (not (<= cost (pass_bound s p))))
(check-sat)
