% RUNKEY  Hash of everything that decides the result of a run.
%
% CALL: [KEY, TEXT] = runKey (VARIABLES, EFFECTVARS, H)
%
%   VARIABLES   scalar struct, see runVariables
%   EFFECTVARS  cell of names of effect variables
%   H           scalar struct, one element of hashModels
%   KEY         64 hexadecimal digits
%   TEXT        '|name=value' of each variable that counts, names sorted; KEY is
%               the hash of H.input and TEXT, so a record that holds both proves
%               them
%
% Numbers count with 15 digits, as they are written for the run (toDigits).
%
% An effect variable with the value that data.head declares anyway does not
% count: a run of the plain model stays the same run when candidate effects
% are added to the case later.

function [key, text] = runKey (variables, effectVars, h)
  names = sort (fieldnames (variables));
  text = '';
  for k = 1:numel (names)
    name = names{k};
    value = toDigits (variables.(name));
    isOff = any (strcmp (name, effectVars)) && ...
            isfield (h.defaults, name) && ...
            toDigits (h.defaults.(name)) == value;
    if ~isOff
      text = [text, sprintf('|%s=%.17g', name, value)];
    end
  end
  key = hash ('sha256', [h.input, text]);
end

%!shared h, v
%! h = struct ('input', 'x', 'defaults', struct ('e', 0));
%! v = struct ('a', 1, 'b', 2);
%!assert (numel (runKey (v, {}, h)), 64)
%!test
%! % neutral effect: the same run; the order of the variables does not count
%! w = struct ('b', 2, 'e', 0, 'a', 1);
%! assert (runKey (w, {'e'}, h), runKey (v, {}, h));
%! w.e = 1;
%! assert (! isequal (runKey (w, {'e'}, h), runKey (v, {}, h)));
%!test
%! w = v;
%! w.a = 1 + 1e-14;
%! assert (! isequal (runKey (w, {}, h), runKey (v, {}, h)));
%! w.a = 1 + eps;
%! [key, text] = runKey (w, {}, h);
%! assert ({key, text}, {runKey(v, {}, h), '|a=1|b=2'});

% SPDX-License-Identifier: GPL-3.0-only
