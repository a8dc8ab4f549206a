; A model of the hypotheses of variant-falls.smt2
; Says: The world is a triangle: v0 with darts a0 a1, v1 with b0 b1, v2 with c0 c1; edges a0b0,
;   a1c0, b1c1. S knows the three vertices, a0b0 and a1c0; e = B1.
; Expected: sat

(set-logic ALL)
(declare-datatypes ((Dart 0)) (((a0) (a1) (b0) (b1) (c0) (c1))))
(declare-datatypes ((MapDart 0)) (((A0) (A1) (B0) (B1) (C0) (C1))))
(define-fun alpha ((x Dart)) Dart
  (ite (= x a0) b0 (ite (= x a1) c0 (ite (= x b0) a0 (ite (= x b1) c1 (ite (= x c0) a1 b1))))))
(define-fun phi ((x MapDart)) Dart
  (ite (= x A0) a0 (ite (= x A1) a1 (ite (= x B0) b0 (ite (= x B1) b1 (ite (= x C0) c0 c1))))))
(define-fun walked0 ((x Dart)) Bool (or (= x a0) (= x a1) (= x b0) (= x c0)))
(define-fun open0 ((x MapDart)) Bool (or (= x B1) (= x C1)))
(define-fun walked1 ((x Dart)) Bool (or (= x a0) (= x a1) (= x b0) (= x b1) (= x c0) (= x c1)))
(define-fun e () MapDart B1)

(assert (forall ((d Dart)) (= (alpha (alpha d)) d)))
(assert (forall ((d Dart)) (not (= (alpha d) d))))
(assert (forall ((d Dart)) (=> (walked0 d) (walked0 (alpha d)))))
(assert (forall ((x MapDart)) (=> (open0 x) (not (walked0 (phi x))))))
(assert (open0 e))
(assert (forall ((d Dart))
  (= (walked1 d) (or (walked0 d) (= d (phi e)) (= d (alpha (phi e)))))))
(check-sat)
