; A model of the hypotheses of turns-reversible.smt2
; Says: One vertex of degree 3, k = 1.
; Expected: sat

(set-logic ALL)
(declare-datatypes ((Dart 0)) (((a0) (a1) (a2))))
(define-fun sigma ((x Dart)) Dart (ite (= x a0) a1 (ite (= x a1) a2 a0)))
(define-fun sigma_inv ((x Dart)) Dart (ite (= x a0) a2 (ite (= x a1) a0 a1)))
(define-fun turn_k ((x Dart)) Dart (ite (= x a0) a1 (ite (= x a1) a2 a0)))
(define-fun back_k ((x Dart)) Dart (ite (= x a0) a2 (ite (= x a1) a0 a1)))
(define-fun turn_k1 ((x Dart)) Dart (ite (= x a0) a2 (ite (= x a1) a0 a1)))
(define-fun back_k1 ((x Dart)) Dart (ite (= x a0) a1 (ite (= x a1) a2 a0)))

(assert (forall ((x Dart)) (= (sigma_inv (sigma x)) x)))
(assert (forall ((x Dart)) (= (sigma (sigma_inv x)) x)))
(assert (forall ((x Dart)) (= (turn_k1 x) (sigma (turn_k x)))))
(assert (forall ((x Dart)) (= (back_k1 x) (back_k (sigma_inv x)))))
(assert (forall ((x Dart)) (= (back_k (turn_k x)) x)))
(assert (forall ((x Dart)) (= (turn_k (back_k x)) x)))
(check-sat)
