% LOADCASE  Loads the user's case from a folder.
%
% CALL: CASE = loadCase ()
%       CASE = loadCase (ROOT, FOLDER)
%       CASE = loadCase (ROOT, FOLDER, 'reading')
%
%   ROOT    folder of the toolbox (text, default: the one of this file)
%   FOLDER  case folder, looked in before the toolbox (text, default pwd)
%   CASE    scalar struct, see newCase; with 'reading' no run can be made of it,
%           and what only runs need (programs, a place) may be missing
%
% A program loads its case once and hands it on. Without arguments it is that of
% the current folder, for published functions that users call with no case at
% hand. Parameters that no run varies are left out (withoutUnvaried).
% withEffects adds the candidate effects of the diagnosis.
%
% Errors: those of readInput and checkCase

function Case = loadCase (varargin)
  raw = readInput (varargin{1:min(nargin, 2)});
  Case = withoutUnvaried (newCase (raw, varargin{3:nargin}));
end

%!test
%! raw = standInCase (tempname ());
%! writeLoadInput (raw.folder);
%! here = cd (raw.folder);
%! clear loadInput
%! Case = loadCase ();
%! cd (here);
%! clear loadInput
%! assert (Case.names, {'a', 'b'});
%! assert (Case.folder, raw.folder);
%! assert (isempty (Case.effects));

% SPDX-License-Identifier: GPL-3.0-only
