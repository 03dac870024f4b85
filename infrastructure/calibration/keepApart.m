% KEEPAPART  Leaves out runs of another source that the runs of this case contradict.
%
% CALL: [STATE, TEXT] = keepApart (STATE, PROBLEM)
%
%   STATE  see newState: others (trustLibrary) is read; its data come back without
%          the runs of such a source, and its misled says so
%   TEXT   that sentence; '': no source is contradicted
%
% Two explanations of how far own runs are off what a source predicts at like places
% (where it knows the mean response as well as a run does): its scatter, or a shift
% of the source as large as the tolerance (oddsOfShift). From three runs on, without
% the farthest, which may be wrong, odds of 20 to 1 tell them apart: a wall that was
% changed outside the model folder, another version of the model. Sixty rows that
% are off outvote the runs of today otherwise.

function [state, text] = keepApart (state, problem)
  text = '';
  for other = state.others
    [odds, t, values] = oddsOfShift (state.data, other, problem);
    if odds > 20 && values.runs > 2
      values.n = sum (strcmp (state.data.stage, other.source));
      text = sentence (['misled.', other.source], values);
      state.misled = strtrim ([state.misled, ' ', text]);
      state.data = keepRows (state.data, ~strcmp (state.data.stage, other.source));
      state.others(strcmp ({state.others.source}, other.source)) = [];
    end
  end
end

%!shared problem, state
%! [problem, state, surrogates, law] = smallCalibration ();
%! state.others = struct ('source', 'import', 'surrogates', {surrogates}, 'search', []);
%! state.data.stage(:) = {'import'};
%! X = [0.5, 1; 0.52, 0.98; 0.5, 1.04];
%! state.data = addRows (state.data, X, law (X) .* [1.03, 1], ones (3, 1), 'verify');
%!test
%! [out, text] = keepApart (state, problem);
%! assert (out.data.stage, repmat ({'verify'}, 3, 1));
%! assert (! isempty (strfind (text, 'The 12 rows of runs.csv are not used: for x')));
%! assert ({out.misled, numel(out.others)}, {text, 0});
%!test
%! % two runs, or one of three, are no proof; nor is half a tolerance
%! for k = 1:2
%!   s = state;
%!   s.data.Z(end, 1) = s.data.Z(end, 1) / (1.03 * (k == 2) + (k == 1));
%!   s.data.Z(end - 1, 1) = s.data.Z(end - 1, 1) / 1.03;
%!   s.data = keepRows (s.data, 1:12 + 2 * (k == 1) + 3 * (k == 2));
%!   [out, text] = keepApart (s, problem);
%!   assert ({text, rows(out.data.X)}, {'', rows(s.data.X)});
%! end
%! state.data.Z(13:15, 1) = state.data.Z(13:15, 1) / 1.02;
%! assert (nthargout (2, @keepApart, state, problem), '');

% SPDX-License-Identifier: GPL-3.0-only
