% Trials of one angle with uncertainties of 5, 0.1 and 0.1: the first counted as much
% as the others, without a word.

%!test
%! folder = reportedCase ('unequalTrials');
%! [status, out] = startCommand (folder, 'check --try');
%! assert (status == 0, out);
%! assert (! isempty (strfind (out, 'weighted by their sd, repeats and sessions: angle')));
%! assert (! isempty (regexp (out, 'angle .*measured 30.15')), out);
%! % in any order; lines whose sd is the same share it
%! file = fullfile (folder, 'measured.csv');
%! text = fileread (file);
%! writeAtomic (file, regexprep (text, '(Slope,angle,34.0,5,deg\n)(.*)$', '$2$1'));
%! [~, out] = startCommand (folder, 'check --try');
%! assert (! isempty (regexp (out, 'angle .*measured 30.15')), out);
%! writeAtomic (file, strrep (text, '34.0,5', '34.0,'));
%! [~, out] = startCommand (folder, 'check');
%! assert (! isempty (strfind (out, 'do not weigh them, as others have none: angle')), out);
%! writeAtomic (file, strrep (text, '34.0,5', '34.0,0.1'));
%! [~, out] = startCommand (folder, 'check --try');
%! assert (! isempty (regexp (out, 'angle .*measured 31.43')), out);
%! assert (! isempty (strfind (out, 'mean of repeated trials: angle')), out);

% SPDX-License-Identifier: GPL-3.0-only
