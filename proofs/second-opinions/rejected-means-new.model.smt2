; A model of the hypotheses of rejected-means-new.smt2
; Says: The world is a triangle: v0 with darts a0 a1, v1 with b0 b1, v2 with c0 c1; edges a0b0,
;   a1c0, b1c1. S knows the three vertices, a0b0 and a1c0; e = B1 leads to v2, and C1 is the true
;   hypothesis.
; Expected: sat

(set-logic ALL)
(declare-datatypes ((Dart 0)) (((a0) (a1) (b0) (b1) (c0) (c1))))
(declare-datatypes ((MapDart 0)) (((A0) (A1) (B0) (B1) (C0) (C1))))
(declare-datatypes ((Degree 0)) (((two))))
(define-fun alpha ((x Dart)) Dart
  (ite (= x a0) b0 (ite (= x a1) c0 (ite (= x b0) a0 (ite (= x b1) c1 (ite (= x c0) a1 b1))))))
(define-fun degree ((x Dart)) Degree two)
(define-fun marked ((x Dart)) Bool (or (= x a0) (= x a1)))
(define-fun seen ((x Dart)) Bool (or (= x a0) (= x a1) (= x b0) (= x b1) (= x c0) (= x c1)))
(define-fun walked ((x Dart)) Bool (or (= x a0) (= x a1) (= x b0) (= x c0)))
(define-fun known ((x MapDart)) Bool (or (= x A0) (= x A1) (= x B0) (= x B1) (= x C0) (= x C1)))
(define-fun open ((x MapDart)) Bool (or (= x B1) (= x C1)))
(define-fun phi ((x MapDart)) Dart
  (ite (= x A0) a0 (ite (= x A1) a1 (ite (= x B0) b0 (ite (= x B1) b1 (ite (= x C0) c0 c1))))))
(define-fun name ((x Dart)) MapDart
  (ite (= x a0) A0 (ite (= x a1) A1 (ite (= x b0) B0 (ite (= x b1) B1 (ite (= x c0) C0 C1))))))
(define-fun degree_map ((x MapDart)) Degree two)
(define-fun home ((x MapDart)) Bool (or (= x A0) (= x A1)))
(define-fun e () MapDart B1)

(assert (forall ((d Dart)) (= (alpha (alpha d)) d)))
(assert (forall ((d Dart)) (not (= (alpha d) d))))
(assert (forall ((d Dart)) (=> (walked d) (and (seen d) (walked (alpha d))))))
(assert (forall ((d Dart)) (=> (seen d) (and (known (name d)) (= (phi (name d)) d)))))
(assert (forall ((x MapDart))
  (=> (known x)
      (and (= (degree_map x) (degree (phi x))) (= (home x) (marked (phi x)))))))
(assert (forall ((x MapDart)) (=> (open x) (and (known x) (not (walked (phi x)))))))
(assert (forall ((d Dart)) (=> (and (seen d) (not (walked d))) (open (name d)))))
(assert (open e))
(assert (seen (alpha (phi e))))
(check-sat)
