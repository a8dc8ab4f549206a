; A model of the hypotheses of bound-pass-grows.smt2
; Says: Three edges, one explored; one and two vertices known.
; Expected: sat

(set-logic ALL)
(define-fun m () Real 3.0)
(define-fun p () Real 1.0)
(define-fun s () Real 1.0)
(define-fun t () Real 2.0)
(define-fun pass_bound ((s Real) (p Real)) Real (+ s (* 2.0 (- s 1.0) (- (* 2.0 m) (* 2.0 p)))))

(assert (<= s t))
(assert (<= p m))
(check-sat)
