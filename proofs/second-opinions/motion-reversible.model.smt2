; A model of the hypotheses of motion-reversible.smt2
; Says: The world is a triangle: v0 with darts a0 a1, v1 with b0 b1, v2 with c0 c1; edges a0b0,
;   a1c0, b1c1. k = 1.
; Expected: sat

(set-logic ALL)
(declare-datatypes ((Dart 0)) (((a0) (a1) (b0) (b1) (c0) (c1))))
(define-fun alpha ((x Dart)) Dart
  (ite (= x a0) b0 (ite (= x a1) c0 (ite (= x b0) a0 (ite (= x b1) c1 (ite (= x c0) a1 b1))))))
(define-fun turn ((x Dart)) Dart
  (ite (= x a0) a1 (ite (= x a1) a0 (ite (= x b0) b1 (ite (= x b1) b0 (ite (= x c0) c1 c0))))))
(define-fun back ((x Dart)) Dart
  (ite (= x a0) a1 (ite (= x a1) a0 (ite (= x b0) b1 (ite (= x b1) b0 (ite (= x c0) c1 c0))))))
(define-fun move ((x Dart)) Dart
  (ite (= x a0) c0 (ite (= x a1) b0 (ite (= x b0) c1 (ite (= x b1) a0 (ite (= x c0) b1 a1))))))
(define-fun d () Dart a0)

(assert (forall ((x Dart)) (= (alpha (alpha x)) x)))
(assert (forall ((x Dart)) (= (back (turn x)) x)))
(assert (forall ((x Dart)) (= (move x) (alpha (turn x)))))
(check-sat)
