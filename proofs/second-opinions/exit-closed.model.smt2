; A model of the hypotheses of exit-closed.smt2
; Says: The world is a triangle: v0 with darts a0 a1, v1 with b0 b1, v2 with c0 c1; edges a0b0,
;   a1c0, b1c1. S knows all of it; d = a0.
; Expected: sat

(set-logic ALL)
(declare-datatypes ((Dart 0)) (((a0) (a1) (b0) (b1) (c0) (c1))))
(declare-datatypes ((MapDart 0)) (((A0) (A1) (B0) (B1) (C0) (C1))))
(declare-datatypes ((Vertex 0)) (((v0) (v1) (v2))))
(define-fun sigma ((x Dart)) Dart
  (ite (= x a0) a1 (ite (= x a1) a0 (ite (= x b0) b1 (ite (= x b1) b0 (ite (= x c0) c1 c0))))))
(define-fun alpha ((x Dart)) Dart
  (ite (= x a0) b0 (ite (= x a1) c0 (ite (= x b0) a0 (ite (= x b1) c1 (ite (= x c0) a1 b1))))))
(define-fun vertex ((x Dart)) Vertex
  (ite (= x a0) v0 (ite (= x a1) v0 (ite (= x b0) v1 (ite (= x b1) v1 v2)))))
(define-fun seen ((x Dart)) Bool (or (= x a0) (= x a1) (= x b0) (= x b1) (= x c0) (= x c1)))
(define-fun walked ((x Dart)) Bool (or (= x a0) (= x a1) (= x b0) (= x b1) (= x c0) (= x c1)))
(define-fun open ((x MapDart)) Bool false)
(define-fun name ((x Dart)) MapDart
  (ite (= x a0) A0 (ite (= x a1) A1 (ite (= x b0) B0 (ite (= x b1) B1 (ite (= x c0) C0 C1))))))
(define-fun d () Dart a0)

(assert (forall ((d Dart)) (= (vertex (sigma d)) (vertex d))))
(assert (forall ((d Dart) (c Dart)) (=> (and (seen d) (= (vertex c) (vertex d))) (seen c))))
(assert (forall ((d Dart)) (=> (walked d) (and (seen d) (walked (alpha d))))))
(assert (forall ((d Dart)) (=> (and (seen d) (not (walked d))) (open (name d)))))
(assert (forall ((x MapDart)) (not (open x))))
(assert (seen d))
(check-sat)
