; A model of the hypotheses of bound-one-pass.smt2
; Says: A triangle, two edges and three vertices known: the last pass, dearest case.
; Expected: sat

(set-logic ALL)
(define-fun m () Real 3.0)
(define-fun p () Real 2.0)
(define-fun s () Real 3.0)
(define-fun tests () Real 1.0)
(define-fun way () Real 3.0)
(define-fun cost_tests () Real 4.0)
(define-fun cost () Real 7.0)
(define-fun pass_bound ((s Real) (p Real)) Real (+ s (* 2.0 (- s 1.0) (- (* 2.0 m) (* 2.0 p)))))

(assert (<= 1.0 s))
(assert (<= way s))
(assert (<= tests (- (* 2.0 m) (* 2.0 p))))
(assert (<= cost_tests (* 2.0 (- s 1.0) tests)))
(assert (= cost (+ way cost_tests)))
(check-sat)
