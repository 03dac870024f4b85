% CHECKPHYSICS  Tells what a variable of a known name may be, if it is not.
%
% CALL: EXPECTED = checkPhysics (NAME, VALUE)
%
%   NAME      name of a variable (text)
%   VALUE     number (SI unit)
%   EXPECTED  '' where VALUE is possible or nothing is known of NAME, else
%             the range in words
%
% The range of restitution and Poisson's ratio is the one that LIGGGHTS takes.
%
% See also: checkVariables, checkLimits

function expected = checkPhysics (name, value)
  positive = 'a number above 0';
  table = {'density', positive, @(v) v > 0; ...
           'radius', positive, @(v) v > 0; ...
           'youngsModulus', positive, @(v) v > 0; ...
           'poissonsRatio', 'a number from 0 to 0.5', ...
           @(v) v >= 0 & v <= 0.5; ...
           'coefRestitution', 'a number above 0.05, at most 1', ...
           @(v) v > 0.05 & v <= 1; ...
           'coefFriction', 'a number from 0', @(v) v >= 0; ...
           'coefRollingFriction', 'a number from 0', @(v) v >= 0; ...
           'percentRayleigh', 'a number above 0, at most 1', ...
           @(v) v > 0 & v <= 1};
  expected = '';
  if ~checkIs ('name', name)
    return
  end
  base = regexprep (name, '(PP|PW|WW|P|W)$', '');
  k = find (strcmp (table(:, 1), base));
  if ~isempty (k) && ~table{k, 3}(value)
    expected = table{k, 2};
  end
end

%!assert (checkPhysics ('densityP', 700), '')
%!assert (checkPhysics ('densityP', 0), 'a number above 0')
%!assert (checkPhysics ('poissonsRatioW', 0.6), ...
%!        'a number from 0 to 0.5')
%!assert (checkPhysics ('anything', -1), '')
%!assert (checkPhysics ('coefRestitutionPP', 1), '')
