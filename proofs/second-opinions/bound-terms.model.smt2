; A model of the hypotheses of bound-terms.smt2
; Says: A world with four edges and three vertices, its last pass.
; Expected: sat

(set-logic ALL)
(define-fun m () Real 4.0)
(define-fun n () Real 3.0)
(define-fun p () Real 3.0)
(define-fun s () Real 3.0)
(define-fun i () Real 2.0)
(define-fun pass_bound ((s Real) (p Real)) Real (+ s (* 2.0 (- s 1.0) (- (* 2.0 m) (* 2.0 p)))))
(define-fun least ((x Real) (y Real)) Real (ite (<= x y) x y))
(define-fun term_1 ((s Real)) Real (+ s (* 2.0 (- s 1.0) (- (* 2.0 m) (* 2.0 (- s 1.0))))))
(define-fun term_2 ((i Real)) Real
  (+ n (* 2.0 (- n 1.0) (- (- (* 2.0 m) (* 2.0 (- n 1.0))) (* 2.0 (- i 1.0))))))

(assert (= s (least (+ p 1.0) n)))
(assert (= i (+ (- p (- n 1.0)) 1.0)))
(check-sat)
