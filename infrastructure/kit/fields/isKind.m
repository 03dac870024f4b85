% ISKIND  Tells whether a value is of a kind that the input may hold.
%
% CALL: YES = isKind (KIND, VALUE)
%
%   KIND   'number'   real finite scalar that is not sparse
%          'integer'  the same, and whole
%          'vector'   row or column of real numbers, not sparse, not empty
%          'text'     row of printable characters (UTF-8), not empty
%          'name'     text of letters, digits and _ that does not start with
%                     a digit, at most 63 long: a variable of LIGGGHTS
%          'folder'   text of letters, digits, _ - + . and characters beyond
%                     ASCII, neither dot nor minus first, at most 100 bytes
%                     long: it cannot leave its folder or break a shell line
%          'struct'   one struct
%          'list'     a text, or a row or column cell that is not empty
%          'nothing'  empty: stands for a field that is not given
%   VALUE  anything
%   YES    true or false
%
% Never throws.

function yes = isKind (kind, value)
  testOf = struct ('number', @isFinite, 'integer', @isWhole, ...
                   'vector', @isVector, 'text', @isText, 'name', @isName, ...
                   'folder', @isFolderName, 'nothing', @isNothing, ...
                   'list', @isList, ...
                   'struct', @(v) isstruct (v) && isscalar (v));
  yes = testOf.(kind) (value);
end

function yes = isWhole (value)
  yes = isFinite (value) && value == fix (value);
end

function yes = isVector (value)
  yes = isNumeric (value) && isvector (value) && ~isempty (value);
end

function yes = isFinite (value)
  yes = isNumeric (value) && isscalar (value) && isfinite (value);
end

function yes = isNumeric (value)
  yes = isnumeric (value) && ~issparse (value) && isreal (value);
end

function yes = isText (value)
  yes = ischar (value) && isrow (value) && ~isempty (value) && ...
        all (value >= 32 & value ~= 127) && isUtf8 (value);
end

% Octave's own functions for paths throw at any other encoding.
function yes = isUtf8 (text)
  yes = true;
  if any (text > 127)
    try
      regexp (text, 'x', 'once');
    catch
      yes = false;
    end
  end
end

function yes = isList (value)
  yes = isText (value) || ...
        (iscell (value) && isvector (value) && ~isempty (value));
end

function yes = isName (text)
  yes = isText (text) && numel (text) <= 63 && ...
        ~isempty (regexp (text, '^[A-Za-z_][A-Za-z0-9_]*$', 'once'));
end

function yes = isFolderName (text)
  plain = ['A':'Z', 'a':'z', '0':'9', '_-+.'];
  yes = isText (text) && numel (text) <= 100 && ...
        all (ismember (text, plain) | text > 127) && ...
        ~any (text(1) == '.-') && isempty (strfind (text, '..'));
end

function yes = isNothing (value)
  yes = (isnumeric (value) || ischar (value) || iscell (value)) && ...
        isempty (value);
end

%!test
%! good = {'number', 1.5; 'number', int32(3); 'integer', 3; ...
%!         'vector', [1; NaN]; 'text', 'a b'; 'text', char([195, 164]); ...
%!         'name', 'coefFrictionPP'; 'folder', 'a-b_c+1.5'; ...
%!         'folder', char([66, 195, 182]); 'nothing', []};
%! bad = {'number', NaN; 'number', 1i; 'number', sparse(1); ...
%!        'number', true; 'number', {}; 'integer', 3.5; 'vector', ones(2); ...
%!        'text', "a\nb"; 'text', char(228); 'name', '1a'; 'name', 'a b'; ...
%!        'name', char([200, 255]); 'folder', '../x'; 'folder', 'a b'; ...
%!        'folder', '-a'; 'folder', 'a;b'; 'struct', struct('a', {1, 2}); ...
%!        'nothing', containers.Map()};
%! assert (all (cellfun (@isKind, good(:, 1), good(:, 2))));
%! assert (! any (cellfun (@isKind, bad(:, 1), bad(:, 2))));

% SPDX-License-Identifier: GPL-3.0-only
