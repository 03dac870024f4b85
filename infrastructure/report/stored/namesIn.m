% NAMESIN  Names in a field of decoded JSON, as a row.
%
% CALL: NAMES = namesIn (WHICH, FIELD)
%
%   WHICH  struct;  FIELD  text, e.g. 'effects'
%   NAMES  1 x n cell of text; empty where the field is, or is not there

function names = namesIn (which, field)
  names = cell (1, 0);
  if isfield (which, field) && ~isempty (which.(field))
    names = cellstr (which.(field))(:)';
  end
end

%!test
%! which = struct ('effects', {{'tilt'; 'drag'}}, 'likely', 'tilt', 'none', []);
%! assert (namesIn (which, 'effects'), {'tilt', 'drag'});
%! assert (namesIn (which, 'likely'), {'tilt'});
%! assert (namesIn (which, 'none'), cell (1, 0));
%! assert (namesIn (which, 'partners'), cell (1, 0));

% SPDX-License-Identifier: GPL-3.0-only
