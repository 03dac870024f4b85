% Random diagnoses and calibrations: no raw error, the same in all writings.

%!test
%! [failures, count] = fuzzDiagnoses ([2001:2004, 3019, 10773, 10805]);
%! assert (isempty (failures), strjoin ([failures, {''}], "\n"));
%! assert (count.diagnoses >= 9);
%! assert (count.named >= 2);

%!test
%! pkg load stk
%! pkg load -nodeps struct optim
%! [failures, count] = fuzzCalibrations (2001:2004);
%! assert (isempty (failures), strjoin ([failures, {''}], "\n"));
%! assert (count.calibrations, 8);

%!testif ; strcmp (getenv ('DECALIOC_SOAK'), '1')
%! [failures, count] = fuzzDiagnoses (10001:11050);
%! assert (isempty (failures), strjoin ([failures, {''}], "\n"));
%! assert (count.diagnoses >= 2000);
%! assert (count.naming > 100);

%!testif ; strcmp (getenv ('DECALIOC_SOAK'), '1')
%! [failures, count] = fuzzCalibrations (10001:10260);
%! assert (isempty (failures), strjoin ([failures, {''}], "\n"));
%! assert (count.calibrations >= 500);

% SPDX-License-Identifier: GPL-3.0-only
