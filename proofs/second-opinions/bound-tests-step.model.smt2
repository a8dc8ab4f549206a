; A model of the hypotheses of bound-tests-step.smt2
; Says: Two vertices known, the second test.
; Expected: sat

(set-logic ALL)
(define-fun s () Real 2.0)
(define-fun tests () Real 1.0)
(define-fun cost () Real 2.0)
(define-fun steps () Real 1.0)
(define-fun cost_after () Real 4.0)

(assert (<= steps (- s 1.0)))
(assert (= cost_after (+ cost (* 2.0 steps))))
(assert (<= cost (* 2.0 (- s 1.0) tests)))
(check-sat)
