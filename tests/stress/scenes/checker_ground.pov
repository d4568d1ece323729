#version 3.7;
global_settings{assumed_gamma 1.0 max_trace_level 60 adc_bailout 0 }
background{rgb 0.0}
camera{perspective location <0.3,1.5,-6.0> direction <0.0,-0.16984155512168936,0.8492077756084468> right <1.0,-0.0,0.0> up <0.0,0.9805806756909201,0.19611613513818402>}
plane{<0.0,1.0,0.0>,0.0 pigment{checker rgb 0.3, rgb 0.9} finish{ambient 0 emission 1 diffuse 0 specular 0 phong 0}}
