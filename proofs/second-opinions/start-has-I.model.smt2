; A model of the hypotheses of start-has-I.smt2
; Says: The world is a triangle: v0 with darts a0 a1, v1 with b0 b1, v2 with c0 c1; edges a0b0,
;   a1c0, b1c1. The robot starts in a0.
; Expected: sat

(set-logic ALL)
(declare-datatypes ((Dart 0)) (((a0) (a1) (b0) (b1) (c0) (c1))))
(declare-datatypes ((MapDart 0)) (((A0) (A1) (B0) (B1) (C0) (C1))))
(declare-datatypes ((Vertex 0)) (((v0) (v1) (v2))))
(declare-datatypes ((Degree 0)) (((two))))
(define-fun sigma ((x Dart)) Dart
  (ite (= x a0) a1 (ite (= x a1) a0 (ite (= x b0) b1 (ite (= x b1) b0 (ite (= x c0) c1 c0))))))
(define-fun alpha ((x Dart)) Dart
  (ite (= x a0) b0 (ite (= x a1) c0 (ite (= x b0) a0 (ite (= x b1) c1 (ite (= x c0) a1 b1))))))
(define-fun vertex ((x Dart)) Vertex
  (ite (= x a0) v0 (ite (= x a1) v0 (ite (= x b0) v1 (ite (= x b1) v1 v2)))))
(define-fun degree ((x Dart)) Degree two)
(define-fun marked ((x Dart)) Bool (or (= x a0) (= x a1)))
(define-fun seen ((x Dart)) Bool (or (= x a0) (= x a1)))
(define-fun walked ((x Dart)) Bool false)
(define-fun known ((x MapDart)) Bool (or (= x A0) (= x A1)))
(define-fun explored ((x MapDart)) Bool false)
(define-fun open ((x MapDart)) Bool (or (= x A0) (= x A1)))
(define-fun phi ((x MapDart)) Dart
  (ite (= x A0) a0 (ite (= x A1) a1 (ite (= x B0) b0 (ite (= x B1) b1 (ite (= x C0) c0 c1))))))
(define-fun name ((x Dart)) MapDart
  (ite (= x a0) A0 (ite (= x a1) A1 (ite (= x b0) B0 (ite (= x b1) B1 (ite (= x c0) C0 C1))))))
(define-fun next ((x MapDart)) MapDart
  (ite (= x A0) A1 (ite (= x A1) A0 (ite (= x B0) B1 (ite (= x B1) B0 (ite (= x C0) C1 C0))))))
(define-fun partner ((x MapDart)) MapDart
  (ite (= x A0) B0 (ite (= x A1) C0 (ite (= x B0) A0 (ite (= x B1) C1 (ite (= x C0) A1 B1))))))
(define-fun degree_map ((x MapDart)) Degree two)
(define-fun home ((x MapDart)) Bool true)
(define-fun fresh ((x Dart)) MapDart
  (ite (= x a0) A0 (ite (= x a1) A1 (ite (= x b0) B0 (ite (= x b1) B1 (ite (= x c0) C0 C1))))))
(define-fun start () Dart a0)

(assert (forall ((d Dart)) (= (vertex (sigma d)) (vertex d))))
(assert (forall ((c Dart) (d Dart)) (=> (= (vertex c) (vertex d)) (= (degree c) (degree d)))))
(assert (forall ((c Dart) (d Dart)) (=> (= (vertex c) (vertex d)) (= (marked c) (marked d)))))
(assert (forall ((d Dart)) (= (seen d) (= (vertex d) (vertex start)))))
(assert (forall ((d Dart)) (not (walked d))))
(assert (forall ((x MapDart))
  (= (known x) (exists ((d Dart)) (and (= (vertex d) (vertex start)) (= x (fresh d)))))))
(assert (forall ((d Dart))
  (=> (= (vertex d) (vertex start))
      (and (= (phi (fresh d)) d) (= (next (fresh d)) (fresh (sigma d)))))))
(assert (forall ((d Dart)) (= (name d) (fresh d))))
(assert (forall ((x MapDart)) (not (explored x))))
(assert (forall ((x MapDart)) (= (degree_map x) (degree start))))
(assert (forall ((x MapDart)) (= (home x) (marked start))))
(assert (forall ((x MapDart)) (= (open x) (known x))))
(check-sat)
